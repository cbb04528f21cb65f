/* Mesh of a drain: a rubber tube with a longitudinal slit, as triangles of its middle surface.
 *
 * The tube lies along x, centred at the origin. Angles are measured about the axis from the top
 * (+y) toward +z, the right side for an observer who looks along +x. The slit is on top; the bottom
 * rests on a fixed strip. Unrolled, the mesh is a grid. Rows are lines across the axis, columns
 * lines along it. Each cell has one diagonal: all have one direction on the right side, and the
 * mirrored one on the left. Alternating diagonals would give a wrong twist.
 *
 * The slit is a lens: its edges form an ellipse on the tube, where material is missing, and nothing
 * is stressed. Nodes have material coordinates: their positions on the tube before it was opened,
 * where the slit is a plain cut. The opening then moves them around the axis. Inner nodes of the
 * slit exist twice, once for each side; its two tips exist once.
 *
 * vbss_drain_mesh_plan computes the sizes of arrays, the owner allocates them, and
 * vbss_drain_mesh_fill computes their contents. */
#ifndef VBSS_DRAIN_MESH_H
#define VBSS_DRAIN_MESH_H

#include "base/linear.h"
#include "base/memory.h"
#include "base/pi.h"

struct vbss_drain_surface;

#define DRAIN_NONE UINT32_MAX
/* From the top to where the fixed strip begins; the strip is 25 degrees to either side of the bottom. Chosen. */
#define DRAIN_STRIP_ANGLE (155.0 / 180.0 * VBSS_PI)

/* N, D, S and R are graded: fine near the slit, see graded_grid.c. */
typedef enum drain_mesh_kind {
    DRAIN_MESH_N,       /* 137 nodes, 240 triangles; the default */
    DRAIN_MESH_D,       /* 159 nodes, 280 triangles */
    DRAIN_MESH_S,       /* 181 nodes, 320 triangles */
    DRAIN_MESH_R,       /* 225 nodes, 400 triangles */
    DRAIN_MESH_UNIFORM, /* equal cells, with or without a slit */
    DRAIN_MESH_6X12,  /* 6 x 12 equal cells, tips and marks on the nearest lines, no fixed strip */
    DRAIN_MESH_KINDS, /* of tubes */
    DRAIN_MESH_SURFACE = DRAIN_MESH_KINDS /* of a host; no slit, no marks */
} drain_mesh_kind;

/* Lengths in m. */
typedef struct drain_mesh_options {
    drain_mesh_kind kind;
    uint32_t divisions; /* graded: cells are divided into this many in each direction, 1..4 */
    /* UNIFORM: 1..512, an even number with a slit; 6..1024, even */
    uint32_t axial_cells, round_cells;
    double radius; /* middle surface */
    double length;
    double slit_length; /* UNIFORM: 0 for a plain tube, which does not use the fields below */
    double opening;     /* at the middle of the slit, along the surface; 0: a plain cut */
    /* Arc from the slit to each of the two marks, at mid-length, before the opening. The opening
     * moves the default 4.5 mm to 5.12 mm. */
    double mark_arc;
    /* SURFACE: checked by vbss_drain_read_surface; no other option is used */
    const struct vbss_drain_surface *surface;
} drain_mesh_options;

/* Sides of the slit, as index. */
enum { DRAIN_LEFT, DRAIN_RIGHT };

/* An edge. nodes[0] to nodes[1] is counter-clockwise in the first triangle, clockwise in the
 * second, which is DRAIN_NONE at a free edge. */
typedef struct drain_edge {
    uint32_t nodes[2], triangles[2];
} drain_edge;

/* Counts of the grid, graded or of equal cells. */
typedef struct drain_grid {
    uint32_t axial_cells, round_cells; /* rows: one more than cells; columns: as many as cells */
    uint32_t tip_rows;                 /* rows from mid-length to a tip of the slit; 0: no slit */
    uint32_t mark_column;              /* columns from the top to a mark; 0: no marks */
} drain_grid;

typedef struct drain_mesh {
    drain_mesh_options options;
    drain_grid grid;
    uint32_t node_count, triangle_count, edge_count, slit_count, anchor_count;
    uint32_t marks[2];       /* nodes of the left and the right mark, or DRAIN_NONE */
    uint32_t slit_middle[2]; /* middle nodes of both edges of the slit */

    /* per node: nodes of rows in order, then the second nodes of the slit, on its left */
    vec3 *rest;
    double *angle;                     /* at rest, -pi to pi */
    double (*material_coordinates)[2]; /* arc from the top and x, before the opening, m */
    double *node_area;                 /* a third of the area of its triangles, m^2 */

    /* per triangle: the right half first, then the left half in mirrored order */
    uint32_t (*triangles)[3];     /* counter-clockwise from outside */
    uint32_t (*opposite_node)[3]; /* node beyond the edge opposite to each corner, or DRAIN_NONE */
    double *angular_width; /* angle about the axis between its outermost nodes at rest, rad */

    drain_edge *edges; /* every edge once */
    /* linked list of the edges whose lower node it is: first of a node, next of an edge */
    uint32_t *first_edge, *next_edge;

    uint32_t *slit_nodes[2];    /* nodes of either edge of the slit, with both tips, along x */
    uint32_t *lip_triangles[2]; /* triangle beside each segment of these edges */
    uint32_t *anchors;          /* nodes of the fixed strip */
} drain_mesh;

/* ---- mesh.c */

/* Sets the options to their defaults. */
void vbss_drain_mesh_defaults(drain_mesh_options *options);

/* Checks the options and computes counts; the arrays are NULL. VBSS_ERROR_OUT_OF_RANGE: invalid
 * options, with error text. */
vbss_result vbss_drain_mesh_plan(vbss_context *context, const drain_mesh_options *options,
                                 drain_mesh *mesh);
enum { DRAIN_MESH_ARRAYS = 15 };
/* Lists the arrays of a planned mesh, which its owner allocates and releases. */
void vbss_drain_mesh_arrays(drain_mesh *mesh, vbss_array arrays[DRAIN_MESH_ARRAYS]);

/* Fills the arrays of a planned mesh. */
void vbss_drain_mesh_fill(drain_mesh *mesh);

/* ---- graded_grid.c: rows go from -x to +x, columns from the top to the bottom, which is column
 * round_cells / 2 */

/* Sets the counts of a graded grid. */
void vbss_drain_plan_graded_grid(drain_mesh *mesh);

/* Position of a row along the axis, m, in any grid. */
double vbss_drain_row_x(const drain_mesh *mesh, uint32_t row);

/* Angle of a column from the top, rad, in any grid. */
double vbss_drain_column_angle(const drain_mesh *mesh, uint32_t column);

/* ---- uniform_grid.c */

/* Checks the options of a grid of equal cells and sets its counts. VBSS_ERROR_OUT_OF_RANGE: no line
 * where a tip or a mark is, or unsuitable counts. */
vbss_result vbss_drain_plan_uniform_grid(vbss_context *context, drain_mesh *mesh);

/* Position of a row along the axis, m, with equal cells. */
double vbss_drain_uniform_row_x(const drain_mesh *mesh, uint32_t row);

/* Angle of a column from the top, rad, with equal cells. */
double vbss_drain_uniform_column_angle(const drain_mesh *mesh, uint32_t column);

/* ---- nodes.c */

/* Sets the numbers of nodes and of slit nodes. */
void vbss_drain_count_nodes(drain_mesh *mesh);

/* Node at a row and column of a side. Columns of both sides begin at the top and meet at
 * the bottom. */
uint32_t vbss_drain_node_index(const drain_mesh *mesh, uint32_t row, uint32_t column, int side);

/* Computes rest positions, angles and material coordinates of all nodes. */
void vbss_drain_compute_nodes(drain_mesh *mesh);

/* ---- slit.c */

/* Whether the row crosses the slit between its tips. */
bool vbss_drain_is_slit_row(const drain_mesh *mesh, uint32_t row);

/* Arc by which the opening moves a point of the right side away from the top, m. `x` along the axis
 * and `arc` from the top, m. */
double vbss_drain_slit_shift(const drain_mesh *mesh, double x, double arc);

/* Lists nodes and triangles at both edges of the slit. */
void vbss_drain_list_slit(drain_mesh *mesh);

/* ---- triangles.c */

/* Lists the triangles of all cells. */
void vbss_drain_list_triangles(drain_mesh *mesh);

/* Lists all edges, and the opposite nodes of all triangles. */
void vbss_drain_list_edges(drain_mesh *mesh);

/* ---- landmarks.c */

/* Finds the nodes of the marks and of the middle of the slit. */
void vbss_drain_find_landmarks(drain_mesh *mesh);

/* Whether the nodes of a column belong to the fixed strip. */
bool vbss_drain_is_anchor_column(const drain_mesh *mesh, uint32_t column);

/* Lists the nodes of the fixed strip. */
void vbss_drain_list_anchors(drain_mesh *mesh);

/* ---- areas.c */

/* Computes areas of nodes and angular widths of triangles. */
void vbss_drain_compute_areas(drain_mesh *mesh);

#endif
