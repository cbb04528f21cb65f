/* Closed polygons and their diagrams, for tests of the inside of lib/knot. */
#ifndef VBSS_TESTS_KNOT_DIAGRAM_H
#define VBSS_TESTS_KNOT_DIAGRAM_H

#include "harness/harness.h"
#include "knot/knot.h"
#include "fixtures/knots.h"

enum { DIAGRAM_VERTICES = 800, DIAGRAM_CROSSINGS = 600 };

/* Memory for both. */
typedef struct diagram {
    harness_memory memory;
    vbss_context *context;
    knot_projector projector;
    knot_gauss_code code, spare;
    knot_polygon polygon; /* of `x` */
    vec3 x[DIAGRAM_VERTICES];
    vbss_array arrays[KNOT_PROJECTOR_ARRAYS + 2 * KNOT_GAUSS_CODE_ARRAYS];
} diagram;
void diagram_begin(diagram *d, uint32_t crossings);
void diagram_end(diagram *d);

knot_diagram_status diagram_project(diagram *d, vec3 direction);
/* Along the first of the fixed directions from k on in which it is plain: that one. */
uint32_t diagram_project_plain(diagram *d, uint32_t k);

/* ---- polygons */

/* p times round the axis z, q times round a ring; p, q > 0: right-handed. */
void diagram_torus(diagram *d, int p, int q, uint32_t count);
void diagram_figure_eight(diagram *d, uint32_t count);
/* Of vertices anywhere in a cube. */
void diagram_random(diagram *d, harness_source *source, uint32_t count);
/* A knot of the scenes, its ends joined at so many times its size. */
void diagram_knot(diagram *d, knot_kind kind, bool mirrored, double finest, double far);
void diagram_mirror(diagram *d);

/* ---- codes, and what is known about them by other means */

/* Crossings as letters, capital over, in the order of the curve; signs in the order of first visits. Entry k is at
 * place k + 0.5. */
void diagram_set_code(knot_gauss_code *code, const char *entries, const char *signs);
void diagram_expect_code(const char *entries, const char *signs, const knot_gauss_code *code);
/* |Delta(-1)| modulo 2^31 - 1 by colourings, and Vassiliev's invariant of degree 2. */
int64_t diagram_determinant(const knot_gauss_code *code);
int64_t diagram_v2(const knot_gauss_code *code);

#endif
