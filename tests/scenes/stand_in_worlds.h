/* The worlds behind the stand-ins for vendors' libraries. NULL: there is no such library, or it is another one. It stays
 * in memory, as adapters would leave it. */
#ifndef VBSS_TESTS_SCENES_STAND_IN_WORLDS_H
#define VBSS_TESTS_SCENES_STAND_IN_WORLDS_H

#include "stand_ins/stand_ins.h"

const stand_in_hd_table *stand_in_arms_of(const char *library);
const stand_in_daq_table *stand_in_lines_of(const char *library);

#endif
