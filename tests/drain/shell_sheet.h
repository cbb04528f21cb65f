/* Shells at random: part of a bent sheet of 1 to 4 by 1 to 3 cells, nodes off by up to a fifth of a cell. */
#ifndef VBSS_TESTS_SHELL_SHEET_H
#define VBSS_TESTS_SHELL_SHEET_H

#include "drain/shell_rig.h"

#include "harness/harness.h"

/* Mesh and input, with free edges on every side; and the shell of it. */
void shell_sheet_draw(harness_source *source, shell_rig *r, vbss_shell_input *in);
void shell_sheet_start(harness_source *source, shell_rig *r);
/* Any rigid motion of the rest state with nodes off by as much as `by`. */
void shell_sheet_deform(harness_source *source, shell_rig *r, double by);

#endif
