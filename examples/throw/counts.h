/* What scenes and devices have counted, in words. */
#ifndef VBSS_EXAMPLES_THROW_COUNTS_H
#define VBSS_EXAMPLES_THROW_COUNTS_H

#include <vblast_ss/vblast_ss.h>

/* Contacts, tries, guard; how well lengths and distances are kept. */
void counts_report_scene(const vbss_scene_statistics *s);
/* Of a hand's device, and of the force on its tool, whose magnitude was at most `largest_force` N. */
void counts_report_device(const char *name, const vbss_device_statistics *in,
                          const vbss_output_statistics *out, double largest_force);

#endif
