/* Internal interface of visuals, shared by the files of lib/visual. A visual only reads the bodies
 * that it draws.
 *
 * config.c has the configuration and visual.c the public object with its list of sources. update.c
 * writes a frame, with one part per body. Threads, needles, graspers and capsules are lofts
 * (loft.c): sections (section.c) moved along a line. The line of a thread comes from spline.c and
 * thread.c, those of rigid bodies from tools.c. ring_simd.c writes the vertices of a ring.
 *
 * A drain is a wall made of curved patches over its triangles. drain.c plans its vertices and
 * wall_simd.c computes them. wall_topology.c has its triangles and all attributes that do not
 * change as the drain moves.
 *
 * Units are SI, and points are in world coordinates unless the comment says otherwise. All numbers
 * are double up to the vertex. Renderers want floats there, and a conversion rounds to the same
 * bits on every machine. */
#ifndef VBSS_VISUAL_VISUAL_H
#define VBSS_VISUAL_VISUAL_H

#include <vblast_ss/visual.h>

#include "base/linear.h"
#include "base/pi.h"
#include "base/slot.h"
#include "replica/replica.h"
#include "scene/api/inspect.h"

/* Sides of a section; points of one, where a seam or creases double some. Capacities, chosen. */
enum {
    VISUAL_MAX_SIDES = 64,
    VISUAL_LOFTS_PER_PART = 4, /* of a grasper */
    VISUAL_MAX_SECTION_POINTS = VISUAL_MAX_SIDES + 8,
    VISUAL_MAX_DOME_RINGS = VISUAL_MAX_SIDES / 4,
    VISUAL_SECTIONS = 8, /* more than a scene of threads, needles, graspers and shears needs */
};

typedef enum visual_section_shape { VISUAL_ROUND = 0, VISUAL_JAW = 1 } visual_section_shape;

/* The next three structs have the layout of the public views. */

typedef struct visual_vertex {
    float position[3], normal[3], texture[2], material[3], value;
} visual_vertex;

typedef struct visual_decal {
    float part, kind, material[3], radius;
} visual_decal;

typedef struct visual_part {
    uint32_t kind, source, body, first_vertex, vertex_count, first_triangle, triangle_count,
        reserved;
} visual_part;

/* Orientation of the first section of a thread's tube. The next frame starts from it. */
typedef struct visual_tube_start {
    const void *thread; /* its identity in scene_geometry */
    vec3 tangent, normal;
} visual_tube_start;

/* A drain as it was drawn. Its triangles, and the attributes of its vertices other than position
 * and normal, depend on these fields only. The next frames reuse them. */
typedef struct visual_wall_record {
    const void *drain; /* its identity in scene_geometry; NULL: none */
    uint32_t divisions, first_vertex, first_triangle;
} visual_wall_record;

/* A loft as it was drawn. Its triangles before `end_triangle` depend on the other fields only. */
typedef struct visual_loft_record {
    visual_section_shape shape;
    uint32_t sides; /* of the section; 0: no loft */
    uint32_t first_vertex, first_triangle;
    uint32_t end_triangle; /* those from here on meet at the last pole */
} visual_loft_record;

/* One frame. Items beyond a capacity are counted but not stored, and the frame is then
 * discarded. */
typedef struct visual_frame {
    visual_vertex *vertices;
    uint32_t (*triangles)[3];
    visual_part *parts;
    visual_decal *decals;
    visual_tube_start *tube_starts;
    /* In the back frame, records that the present update has not replaced yet tell what the one
     * before the last has left in the arrays. */
    visual_wall_record *walls;
    visual_loft_record *lofts;
    uint32_t vertex_count, triangle_count, part_count, decal_count;
    uint32_t tube_start_count, wall_count, loft_count;
} visual_frame;

/* A scene, a body or a replica that the visual shows. */
typedef struct visual_source {
    uint32_t number; /* as reported to the host; 0: the entry is free */
    bool is_replica;
    scene_handle_type type; /* unless it is a replica */
    void *handle;
} visual_source;

/* Points of a circle at equal steps, and others at the corners of a jaw. `position` and `normal`
 * are for a ring of radius 1, in the axes of the ring: its normal, then tangent x normal. The points
 * run counter-clockwise seen against the tangent. */
typedef struct visual_section {
    visual_section_shape shape;
    uint32_t sides;      /* of the shape; 0: the section is not made yet */
    uint32_t count;      /* points */
    uint32_t distinct;   /* without the last point of a circle, which is the first one again */
    uint32_t dome_rings; /* rings of a dome of the same fineness */
    double position[2][VISUAL_MAX_SECTION_POINTS], normal[2][VISUAL_MAX_SECTION_POINTS];
    float perimeter_fraction[VISUAL_MAX_SECTION_POINTS];
    double dome_sine[VISUAL_MAX_DOME_RINGS + 1], dome_cosine[VISUAL_MAX_DOME_RINGS + 1];
    /* Points from which the surface continues to the next one; the triangles between two rings, of
     * which the first has the vertices from 0 on and the second those from `count` on. */
    uint32_t joint_count, joints[VISUAL_MAX_SECTION_POINTS];
    uint32_t strip[2 * VISUAL_MAX_SECTION_POINTS][3];
} visual_section;

typedef struct visual_object {
    vbss_context *context;
    vbss_visual_config config;
    vec3 origin;
    visual_source *sources;
    uint32_t last_source; /* largest number given so far */
    visual_frame frames[2];
    uint32_t front; /* index of the frame that hosts see */
    uint64_t generation, updates;
    bool wide;                                /* whether the wide copies of the hot loops run */
    visual_section sections[VISUAL_SECTIONS]; /* those that were used last */
    uint32_t next_section;                    /* the one that makes room for another */

    /* Scratch, used within one update only. */
    vec3 *node_vectors; /* per node: second derivatives of a thread, or normals of a drain */
    double *elimination_ratios; /* per node: ratios of the elimination in spline.c */
} visual_object;

/* ---- config.c */

/* Reads a configuration of the host; NULL: the defaults. Returns VBSS_OK, VBSS_ERROR_STRUCT_SIZE,
 * VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_visual_read_config(vbss_context *context, const vbss_visual_config *config,
                                    vbss_visual_config *own);

/* ---- vertices and triangles */

/* A vertex before it is converted to floats. */
typedef struct visual_point {
    vec3 position, normal; /* m; unit */
    double texture[2];
    vec3 material;
    double value;
} visual_point;

/* Clamps, so that the conversion cannot overflow. */
#define VISUAL_LARGEST 1e30
static inline float visual_to_float(double x)
{
    return (float)vbss_min(vbss_max(x, -VISUAL_LARGEST), VISUAL_LARGEST);
}

static inline void visual_store(float out[3], vec3 v)
{
    out[0] = visual_to_float(v.x);
    out[1] = visual_to_float(v.y);
    out[2] = visual_to_float(v.z);
}

/* Stores vertex number `index` if there is room for it. */
static inline void visual_set_vertex(const visual_object *v, visual_frame *f, uint32_t index,
                                     const visual_point *p)
{
    if (index < v->config.vertex_capacity) {
        visual_vertex *out = &f->vertices[index];
        visual_store(out->position, vec3_sub(p->position, v->origin));
        visual_store(out->normal, p->normal);
        out->texture[0] = visual_to_float(p->texture[0]);
        out->texture[1] = visual_to_float(p->texture[1]);
        visual_store(out->material, p->material);
        out->value = visual_to_float(p->value);
    }
}

/* Adds a triangle of three vertices, counter-clockwise seen from outside. */
static inline void visual_add_triangle(const visual_object *v, visual_frame *f, uint32_t a,
                                       uint32_t b, uint32_t c)
{
    if (f->triangle_count < v->config.triangle_capacity) {
        uint32_t *out = f->triangles[f->triangle_count];
        out[0] = a;
        out[1] = b;
        out[2] = c;
    }
    f->triangle_count++;
}

/* ---- visual.c */
extern const vbss_kind vbss_visual_kind_of_slot;

/* ---- update.c */

/* Adds a decal to the current part. `material` is a position at rest, m; `radius` is in m. */
void vbss_visual_add_decal(const visual_object *v, visual_frame *f, vbss_visual_spot_kind kind,
                           vec3 material, double radius);
/* Whether the frame is within all capacities so far. */
bool vbss_visual_fits(const visual_object *v, const visual_frame *f);

/* ---- section.c */

/* Finds or makes a circular section that is as fine as tube_tolerance requires at this radius, m.
 * It is valid until VISUAL_SECTIONS others were made. */
const visual_section *vbss_visual_round_section(visual_object *v, double radius);
/* The section of a jaw: a semicircle with a flat side toward the other jaw. */
const visual_section *vbss_visual_jaw_section(visual_object *v, double radius);
/* Length of a chord that deviates from a circle of this curvature (1/m) by the tolerance, m. */
double vbss_visual_max_chord(double curvature, double tolerance);

/* ---- loft.c */

/* A position on the line, and the section there. */
typedef struct visual_ring {
    vec3 centre, tangent, normal; /* m; unit; unit, across the tangent: first axis of the section */
    double radius;                /* m */
    double radial, axial;         /* components of the surface's normal across and along the line */
    double arc_length, value;     /* m; value of the vertices */
} visual_ring;

/* A surface under construction, ring by ring. */
typedef struct visual_loft {
    const visual_object *v;
    visual_frame *frame;
    const visual_section *section;
    visual_loft_record *record;          /* NULL: there is no room for one */
    uint32_t kept_triangles;             /* the frame has the triangles before this one already */
    uint32_t previous;                   /* first vertex of the previous ring or pole */
    bool has_previous, previous_is_pole; /* a pole is a single vertex */
    double scale; /* radius of the ring whose points `across` has, m; negative: none */
    float across[VISUAL_MAX_SECTION_POINTS][2]; /* as in `material` of the vertices, m */
} visual_loft;

void vbss_visual_begin_loft(visual_loft *loft, const visual_object *v, visual_frame *f,
                            const visual_section *section);
/* Adds a ring and connects it to the previous one. */
void vbss_visual_add_ring(visual_loft *loft, const visual_ring *ring);
/* Adds a single vertex, at which the surface begins or ends. Each loft ends with one. */
void vbss_visual_add_pole(visual_loft *loft, const visual_ring *ring);
/* Adds a hemisphere: before `ring` at the start of the line, or after it at the end. */
void vbss_visual_add_dome(visual_loft *loft, const visual_ring *ring, bool at_start);

/* A capsule, which may taper. */
typedef struct visual_capsule {
    vec3 start, end, tangent, normal; /* m; along the axis, unit; across it, unit */
    double radius, end_radius, value; /* m; value of the vertices */
} visual_capsule;

void vbss_visual_add_capsule(const visual_object *v, visual_frame *f, const visual_section *section,
                             const visual_capsule *capsule);
/* ---- ring_simd.c */

/* Writes the vertices of a ring from `out` on. */
void vbss_visual_write_ring_plain(const visual_loft *loft, const visual_ring *ring,
                                  visual_vertex *out);
void vbss_visual_write_ring_wide(const visual_loft *loft, const visual_ring *ring,
                                 visual_vertex *out);
/* Writes the triangles between two rings. `first` is the first vertex of the first one. */
void vbss_visual_write_strip_plain(const visual_section *section, uint32_t first, uint32_t *out);
void vbss_visual_write_strip_wide(const visual_section *section, uint32_t first, uint32_t *out);

/* ---- spline.c: the natural cubic spline through the nodes of a thread */

/* Computes the second derivatives at the nodes, 1/m. The parameter is the rest length: `lengths`
 * has one per segment, m. `ratios` is scratch, one per node. */
void vbss_visual_solve_spline(const vec3 *x, const double *lengths, uint32_t node_count,
                              vec3 *second_derivatives, double *ratios);

/* ---- line_simd.c: points of that spline */

typedef struct visual_line {
    const vec3 *nodes, *second_derivatives; /* m; 1/m */
    const double *lengths;                  /* of the segments, at rest, m */
} visual_line;

/* A run of points, as many as the scratch of an update holds. */
enum { VISUAL_LINE_POINTS = 64 };
typedef struct visual_line_points {
    uint32_t count, segment[VISUAL_LINE_POINTS];
    double fraction[VISUAL_LINE_POINTS];                              /* of the segment */
    double arc_length[VISUAL_LINE_POINTS], value[VISUAL_LINE_POINTS]; /* of the rings there */
    vec3 centre[VISUAL_LINE_POINTS], tangent[VISUAL_LINE_POINTS];     /* results: m; unit */
} visual_line_points;

/* Computes the points and the tangents there. A tangent without a direction is zero. */
void vbss_visual_find_line_points_plain(const visual_line *line, visual_line_points *points);
void vbss_visual_find_line_points_wide(const visual_line *line, visual_line_points *points);

/* ---- thread.c */

/* `identity` tells the thread from others: the tube of the next frame starts from this one. */
void vbss_visual_draw_thread(visual_object *v, visual_frame *f, const scene_thread_info *thread,
                             const void *identity);
/* Transports the normal of a rotation-minimising frame from one point of a line to another.
 * Tangents and normals are unit vectors. */
vec3 vbss_visual_transport_normal(vec3 from, vec3 tangent, vec3 normal, vec3 to,
                                  vec3 tangent_there);

/* ---- tools.c */

void vbss_visual_draw_needle(visual_object *v, visual_frame *f, const scene_needle_info *needle);
void vbss_visual_draw_grasper(visual_object *v, visual_frame *f, const scene_grasper_info *g);
/* Draws a capsule of another rigid body, which has this orientation. */
void vbss_visual_draw_capsule(visual_object *v, visual_frame *f, quat orientation,
                              const scene_capsule_info *capsule);

/* ---- drain.c */

/* `identity` tells the drain from others, whose topology is not reused. */
void vbss_visual_draw_drain(visual_object *v, visual_frame *f, const scene_drain_info *d,
                            const void *identity);

/* ---- the wall of a drain
 *
 * The patch over a triangle with normals at its corners is a cubic surface with quadratic normals
 * (Vlachos, Peters, Boyd and Mitchell, Curved PN Triangles, 2001). The curve of an edge depends on
 * its own corners only, so neighbouring patches share it. All edges have the same number of
 * divisions. The patches are the middle surface; the outer and the inner face are half the
 * thickness away. Rims close the wall where the mesh ends.
 *
 * The vertices of a face are numbered by node, then by edge, then by triangle, so neighbouring
 * triangles share them. Those of the rims follow: per free edge two at each division, which no face
 * shares, because rims are sharp. */
typedef struct visual_wall {
    const scene_drain_info *drain;
    vec3 *normals;       /* per node, unit */
    uint32_t divisions;  /* per edge */
    uint32_t face_count; /* vertices of a face */
    uint32_t rim_count;  /* free edges */
    uint32_t first_vertex, first_triangle;
    double half_thickness; /* m */
    vec3 origin;           /* of the vertices, m */
    visual_vertex *outer;  /* vertex of node 0 on the outer face; the inner face follows */
    uint32_t (*triangles)[3];
} visual_wall;

/* Number of vertices strictly inside a divided triangle. */
static inline uint32_t visual_interior_vertices(uint32_t divisions)
{
    return divisions < 3 ? 0 : (divisions - 1) * (divisions - 2) / 2;
}
static inline uint32_t visual_wall_vertices(const visual_wall *w)
{
    return 2 * w->face_count + 2 * (w->divisions + 1) * w->rim_count;
}
static inline uint32_t visual_wall_triangles(const visual_wall *w)
{
    return 2 * w->divisions * (w->divisions * w->drain->triangle_count + w->rim_count);
}

/* ---- wall_simd.c: positions and normals */

/* Computes the normals of the nodes: means of the normals of their triangles, exact on a sphere
 * (Max 1999). */
void vbss_visual_find_wall_normals_plain(const visual_wall *w);
void vbss_visual_find_wall_normals_wide(const visual_wall *w);
/* Writes the vertices on the edges. Returns the bound of their chord error, m: with n divisions, no
 * chord is farther from its curve than this divided by n^2. */
double vbss_visual_write_wall_edges_plain(const visual_wall *w);
double vbss_visual_write_wall_edges_wide(const visual_wall *w);
/* Writes all other vertices. */
void vbss_visual_write_wall_plain(const visual_wall *w);
void vbss_visual_write_wall_wide(const visual_wall *w);

/* ---- wall_topology.c */

/* Writes the triangles, and texture, material and value of all vertices. */
void vbss_visual_write_wall_topology(const visual_wall *w);
/* Copies them from a wall of the same drain with the same divisions in another frame. */
void vbss_visual_copy_wall_topology(const visual_wall *w, const visual_frame *from,
                                    const visual_wall_record *record);

#endif
