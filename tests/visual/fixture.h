/* What the tests of visuals share: a watched context, looks at what was drawn, and whether that is a closed surface. */
#ifndef VBSS_TESTS_VISUAL_FIXTURE_H
#define VBSS_TESTS_VISUAL_FIXTURE_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "visual/visual.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_visual_config config; /* the defaults; change it before making */
    vbss_visual *visual;
} fixture;

static inline void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_visual_config_init(&f->config, sizeof f->config));
}

static inline void make(fixture *f)
{
    expect_ok(vbss_visual_create(f->context, &f->config, &f->visual));
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

/* ---- what was drawn (mesh.c) */

typedef struct triangle {
    uint32_t corner[3];
} triangle;

typedef struct drawn {
    const visual_vertex *vertices;
    const triangle *triangles;
    const visual_part *parts;
    const visual_decal *decals;
    uint32_t vertex_count, triangle_count, part_count, decal_count;
} drawn;
/* Updates, and looks. */
drawn draw(const fixture *f);
drawn get_drawn(const fixture *f);
static inline vec3 position_of(const drawn *d, uint32_t vertex)
{
    const float *p = d->vertices[vertex].position;
    return vec3_make((double)p[0], (double)p[1], (double)p[2]);
}
static inline vec3 normal_of(const drawn *d, uint32_t vertex)
{
    const float *n = d->vertices[vertex].normal;
    return vec3_make((double)n[0], (double)n[1], (double)n[2]);
}
static inline vec3 material_of(const drawn *d, uint32_t vertex)
{
    const float *m = d->vertices[vertex].material;
    return vec3_make((double)m[0], (double)m[1], (double)m[2]);
}

/* Sides of a part's triangles that do not belong to exactly one triangle each way, where vertices at the same place count as
 * one; of graspers, whose jaws may touch, as many each way. */
uint32_t open_sides(const drawn *d, const visual_part *part);
/* Triangles with a face that looks away from a normal at a corner of it, or with no face. */
uint32_t inverted_triangles(const drawn *d, const visual_part *part);
/* The largest | |n| - 1 | of a part. */
double normal_error(const drawn *d, const visual_part *part);
/* Of a closed part, m^3; positive when its triangles look outward. */
double volume_of(const drawn *d, const visual_part *part);
/* Closed, nothing inverted, unit normals, triangles of its own vertices only. */
void expect_sound(const drawn *d, const visual_part *part);

/* ---- bodies (mesh.c) */
/* Nodes on a helix of that radius and rise a turn, 12 nodes a turn; a thread of that radius through them. */
vbss_thread *helix(const fixture *f, uint32_t nodes, double radius, double rise,
                   double thread_radius);

#endif
