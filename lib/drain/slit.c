/* Slit: its opening, and the nodes and triangles at its edges. */
#include "drain/mesh.h"

bool vbss_drain_is_slit_row(const drain_mesh *m, uint32_t row)
{
    uint32_t middle = m->grid.axial_cells / 2;
    return row + m->grid.tip_rows > middle && row < middle + m->grid.tip_rows;
}

/* A cut from -a to a opens to the ellipse b sqrt(1 - (x/a)^2). The shift of all other points is the
 * harmonic function with these values at the cut, zero on the line beyond the tips, and decay far
 * away. With z = (x + i arc)/a and Joukowski's map 2 z = zeta + 1/zeta, |zeta| >= 1, it is b
 * Im(-1/zeta) = b Im(zeta)/|zeta|^2. A factor that is 1 at the cut makes it zero where the fixed
 * strip begins. */
double vbss_drain_slit_shift(const drain_mesh *m, double x, double arc)
{
    double fraction = arc / (DRAIN_STRIP_ANGLE * m->options.radius);
    if (m->grid.tip_rows == 0 || m->options.opening == 0.0 || fraction >= 1.0) {
        return 0.0;
    }
    double a = vbss_drain_row_x(m, m->grid.axial_cells / 2 + m->grid.tip_rows);
    double re = fabs(x) / a, im = arc / a;

    /* zeta = z + sqrt(z^2 - 1), the root in the first quadrant. Division gives its smaller part
     * without cancellation. */
    double square = (re - 1.0) * (re + 1.0) - im * im, twice = 2.0 * re * im;
    double larger = sqrt(0.5 * (sqrt(square * square + twice * twice) + fabs(square)));
    if (larger == 0.0) { /* at a tip */
        return 0.0;
    }
    double smaller = re * im / larger;
    re += square > 0.0 ? larger : smaller;
    im += square > 0.0 ? smaller : larger;
    return 0.5 * m->options.opening * (im / (re * re + im * im)) * (1.0 - fraction * fraction);
}

/* The triangle of an edge of the slit, which is a free edge. */
static uint32_t triangle_of_edge(const drain_mesh *m, uint32_t p, uint32_t q)
{
    uint32_t s = m->first_edge[p < q ? p : q];
    while (m->edges[s].nodes[0] + m->edges[s].nodes[1] != p + q) {
        s = m->next_edge[s];
    }
    return m->edges[s].triangles[0];
}

void vbss_drain_list_slit(drain_mesh *m)
{
    uint32_t first = m->grid.axial_cells / 2 - m->grid.tip_rows;
    for (uint32_t k = 0; k < m->slit_count; k++) {
        m->slit_nodes[DRAIN_LEFT][k] = vbss_drain_node_index(m, first + k, 0, DRAIN_LEFT);
        m->slit_nodes[DRAIN_RIGHT][k] = vbss_drain_node_index(m, first + k, 0, DRAIN_RIGHT);
    }
    for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
        const uint32_t *nodes = m->slit_nodes[side];
        for (uint32_t k = 0; k + 1 < m->slit_count; k++) {
            m->lip_triangles[side][k] = triangle_of_edge(m, nodes[k], nodes[k + 1]);
        }
    }
}
