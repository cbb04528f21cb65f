/* Shapes as a test knows them, and what a search over them must list, by trying all pairs. */
#ifndef VBSS_TESTS_COLLISION_SHAPES_MODEL_H
#define VBSS_TESTS_COLLISION_SHAPES_MODEL_H

#include "harness/harness.h"

/* Candidates as the view shows them. */
typedef struct candidate {
    uint32_t kind, shape_a, a, shape_b, b;
} candidate;

typedef enum model_kind { MODEL_CHAIN, MODEL_CAPSULES, MODEL_MESH } model_kind;

typedef struct model_shape {
    model_kind kind;
    bool removed;
    uint32_t node_count, edge_count, triangle_count;
    uint32_t (*edges)[2];
    uint32_t (*triangles)[3];
    double *rest; /* of a chain; NULL: neighbours alone are excluded */
    double *
        arcs; /* of a mesh, between any two nodes, at least `near`; NULL: neighbours alone are excluded */
    double near;
    double radius;
    vec3 *start, *end;
} model_shape;

enum { MODEL_SHAPES = 8 };
typedef struct model {
    vbss_collision_config config;
    bool exact; /* all gaps between boxes are exact, too */
    uint32_t count;
    model_shape shapes[MODEL_SHAPES];
} model;

/* All numbers that decide about exclusion are multiples of this: sums and products are exact. */
#define MODEL_UNIT (1.0 / 1024.0)

void model_begin(model *m);
void model_end(model *m);

/* Shapes at the origin; they are named in the order in which they are added. `rest` may be NULL. */
model_shape *model_chain(model *m, uint32_t node_count, const double *rest, double radius);
model_shape *model_capsules(model *m, uint32_t capsule_count, double radius);
model_shape *model_mesh(model *m, uint32_t node_count, const uint32_t (*triangles)[3],
                        uint32_t triangle_count, double radius);
/* A sheet of columns times rows nodes. */
model_shape *model_sheet(model *m, uint32_t columns, uint32_t rows, double radius);
/* A sheet of which a slit parts the nodes of a row that are not at its ends; those above it are doubled
 * in the end. */
model_shape *model_slit_sheet(model *m, uint32_t columns, uint32_t rows, uint32_t slit_row,
                              double radius);
/* What is nearer than `distance` along a mesh whose nodes are `at` is left out. */
void model_leave_out_near(model_shape *s, const vec3 *at, double distance);

/* A configuration and one to four shapes of any kind, small enough to try all pairs. */
void model_draw(model *m, harness_source *source);
/* How nodes lie and move: a MODEL_ constant. */
typedef enum model_motion {
    MODEL_CROWDED, /* about as far apart as they reach */
    MODEL_FAR,     /* the same, 1e4 from the origin */
    MODEL_FLAT,    /* in one plane */
    MODEL_LATTICE, /* at places of a lattice: boxes touch */
    MODEL_ONE_POINT,
    MODEL_HUGE,    /* far from start to end */
    MODEL_RESTING, /* start is end */
    MODEL_MOTIONS
} model_motion;
void model_draw_motion(model *m, model_motion motion, harness_source *source);

/* The same in an object. */
void model_add_to(const model *m, vbss_collision *collision);
void model_move(const model *m, vbss_collision *collision);

/* Whether the candidates are sorted, each once, those that must be, and no others: `first_name` is what
 * the object calls shape 0. */
void model_check(const model *m, vbss_collision *collision, uint32_t first_name);

/* ---- looking at an object */
vbss_view shapes_view(vbss_collision *collision, vbss_collision_field field);
vbss_collision_statistics shapes_statistics(vbss_collision *collision);
/* Tests that the sign of w.w' ended; 0 for other methods than VBLAST. */
uint64_t shapes_sign_tests_ended(vbss_collision *collision);
/* Searches, and looks at the list. */
const candidate *shapes_find(vbss_collision *collision, uint32_t *count);
/* Asserts that both list the same. */
void shapes_expect_same_list(vbss_collision *one, vbss_collision *other);

#endif
