/* The scene of the scripted hands that pass a needle, and their log. Apart, as the headers of examples and of the library have types
 * of the same name. */
#ifndef VBSS_TESTS_HANDS_STAGE_H
#define VBSS_TESTS_HANDS_STAGE_H

#include <vblast_ss/scene.h>

/* One at a time; the hands rest. */
vbss_result stage_create(vbss_context **context, vbss_scene **scene);
void stage_destroy(void);
/* The bytes of a log, to be freed; NULL: the file cannot be read. */
uint8_t *stage_read_log(const char *path, uint64_t *count);

#endif
