/* The mesh of the drain: a rubber tube with a longitudinal slit, as triangles of its middle surface.
 *
 * The tube lies along x, centred at the origin. Angles go round the axis from the top (+y) towards +z, which is
 * the right side for who looks along +x. The slit is on top, the bottom rests on a strip that does not move.
 * Seen flat, the mesh is a grid: rows are lines across the axis, columns lines along it, and each cell has one
 * diagonal, all in one direction on the right side and mirrored on the left. Alternating diagonals would get
 * twist wrong.
 *
 * The slit is a lens: its edges form an ellipse on the tube, material is missing, nothing is under stress. Nodes
 * have material coordinates, their places on the tube before it was opened, where the slit is a plain cut; the
 * opening then moves them round the axis. Inner nodes of the slit are doubled, one a side; its two tips are
 * single.
 *
 * Rooms for the arrays: plan says what is needed, whoever owns the mesh gets it, fill writes it. */
#ifndef VBSS_DRAIN_MESH_H
#define VBSS_DRAIN_MESH_H

#include "base/linear.h"
#include "base/memory.h"

#define DRAIN_NONE UINT32_MAX
#define DRAIN_PI 3.14159265358979323846
/* From the top to where the fixed strip begins; the strip is 25 degrees to either side of the bottom. */
#define DRAIN_STRIP_ANGLE (155.0 / 180.0 * DRAIN_PI)

/* The graded ones, N to R, are fine where the slit is; graded_grid.c lists them. */
typedef enum drain_mesh_kind {
    DRAIN_MESH_N,       /* 137 nodes, 240 triangles; the default */
    DRAIN_MESH_D,       /* 159 nodes, 280 triangles */
    DRAIN_MESH_S,       /* 181 nodes, 320 triangles */
    DRAIN_MESH_R,       /* 225 nodes, 400 triangles */
    DRAIN_MESH_UNIFORM, /* equal cells, with a slit or without */
    DRAIN_MESH_PAPER, /* VBLaST-SS: 6 x 12 equal cells; tips, marks at the nearest lines; no fixed strip */
    DRAIN_MESH_KINDS
} drain_mesh_kind;

/* Lengths in m. */
typedef struct drain_mesh_options {
    drain_mesh_kind kind;
    uint32_t divisions; /* N, D, S, R: into so many each way a cell is divided, 1 to 4 */
    uint32_t axial_cells, round_cells; /* UNIFORM: 1 to 512, even with a slit; 6 to 1024, even */
    double radius;                     /* of the middle surface */
    double length;
    double slit_length; /* UNIFORM: 0 for a plain tube, which reads nothing below */
    double opening;     /* at the middle of the slit, along the surface; 0: a plain cut */
    /* From the slit to each of the two marks, at mid-length, before the opening, which moves the usual
     * 4.5 mm to 5.12 mm. */
    double mark_arc;
} drain_mesh_options;

/* Both index what comes in pairs. */
enum { DRAIN_LEFT, DRAIN_RIGHT };

/* An edge of triangles. The first triangle runs along it from nodes[0] to nodes[1], the second, DRAIN_NONE at
 * a free edge, back. */
typedef struct drain_edge {
    uint32_t nodes[2], triangles[2];
} drain_edge;

/* Lines of the grid: equal cells, or those that graded_grid.c lists. */
typedef struct drain_grid {
    uint32_t axial_cells, round_cells; /* one row more than cells; as many columns as cells */
    uint32_t tip_rows;                 /* rows from mid-length to a tip of the slit; 0: no slit */
    uint32_t mark_column;              /* columns from the top to a mark; 0: no marks */
} drain_grid;

typedef struct drain_mesh {
    drain_mesh_options options;
    drain_grid grid;
    uint32_t node_count, triangle_count, edge_count, slit_count, anchor_count;
    uint32_t marks[2];       /* nodes, left and right, or DRAIN_NONE */
    uint32_t slit_middle[2]; /* of the slit's edges */

    /* a node; nodes of rows in order, then those that double the slit on its left */
    vec3 *rest;
    double *angle;                     /* at rest, over -pi to pi */
    double (*material_coordinates)[2]; /* arc from the top and x, before the opening */
    double *node_area;                 /* a third of that of its triangles */

    /* a triangle; the left half of them in the order of the right half that they mirror */
    uint32_t (*triangles)[3];     /* counter-clockwise seen from outside */
    uint32_t (*opposite_node)[3]; /* beyond the side opposite to each node, or DRAIN_NONE */
    double *angular_width;        /* angle round the axis between its outermost nodes at rest */

    drain_edge *edges;                /* each once */
    uint32_t *first_edge, *next_edge; /* of a node, after a side: those whose lesser node it is */

    uint32_t *slit_nodes[2];    /* nodes of either edge with both tips, along x */
    uint32_t *lip_triangles[2]; /* the triangles between them, one less */
    uint32_t *anchors;          /* nodes of the strip */
} drain_mesh;

/* ---- making one (mesh.c) */
void vbss_drain_mesh_defaults(drain_mesh_options *options);
/* Checks the options and counts; the arrays are NULL. */
vbss_result vbss_drain_mesh_plan(vbss_context *context, const drain_mesh_options *options,
                                 drain_mesh *mesh);
enum { DRAIN_MESH_ARRAYS = 15 };
/* What a planned mesh has room for, to be allocated and released with its owner. */
void vbss_drain_mesh_arrays(drain_mesh *mesh, vbss_array arrays[DRAIN_MESH_ARRAYS]);
void vbss_drain_mesh_fill(drain_mesh *mesh);

/* ---- lines (graded_grid.c): rows from -x to +x, columns from the top to the bottom, which is column round_cells / 2 */
void vbss_drain_plan_graded_grid(drain_mesh *mesh);
double vbss_drain_row_x(const drain_mesh *mesh, uint32_t row);
double vbss_drain_column_angle(const drain_mesh *mesh, uint32_t column);
/* ---- lines of equal cells (uniform_grid.c) */
vbss_result vbss_drain_plan_uniform_grid(vbss_context *context, drain_mesh *mesh);
double vbss_drain_uniform_row_x(const drain_mesh *mesh, uint32_t row);
double vbss_drain_uniform_column_angle(const drain_mesh *mesh, uint32_t column);

/* ---- nodes (nodes.c) */
void vbss_drain_count_nodes(drain_mesh *mesh);
/* Columns of both sides begin on top and meet at the bottom. */
uint32_t vbss_drain_node_index(const drain_mesh *mesh, uint32_t row, uint32_t column, int side);
void vbss_drain_compute_nodes(drain_mesh *mesh);

/* ---- slit (slit.c) */
bool vbss_drain_is_slit_row(const drain_mesh *mesh, uint32_t row); /* and no tip */
/* Arc by which the opening moves a point of the right side away from the top. */
double vbss_drain_slit_shift(const drain_mesh *mesh, double x, double arc);
void vbss_drain_list_slit(drain_mesh *mesh);

/* ---- triangles and their neighbours (triangles.c) */
void vbss_drain_list_triangles(drain_mesh *mesh);
void vbss_drain_list_edges(drain_mesh *mesh);

/* ---- marks and the fixed strip (landmarks.c) */
void vbss_drain_find_landmarks(drain_mesh *mesh);
bool vbss_drain_is_anchor_column(const drain_mesh *mesh, uint32_t column);
void vbss_drain_list_anchors(drain_mesh *mesh);

/* ---- areas and widths (areas.c) */
void vbss_drain_compute_areas(drain_mesh *mesh);

#endif
