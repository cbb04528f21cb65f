/* How a rigid mesh lies, from three of its vertices. */
#include <math.h>

#include "replay_page/film.h"

typedef struct v3 {
    double x, y, z;
} v3;

static v3 at(const film_vertex *v)
{
    return (v3){(double)v->position[0], (double)v->position[1], (double)v->position[2]};
}

static v3 less(v3 a, v3 b)
{
    return (v3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double dot(v3 a, v3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static v3 cross(v3 a, v3 b)
{
    return (v3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static v3 unit(v3 a)
{
    double length = sqrt(dot(a, a));
    return length > 0.0 ? (v3){a.x / length, a.y / length, a.z / length} : (v3){1.0, 0.0, 0.0};
}

/* Rows: along the first side, across in the triangle's plane, out of it. */
static void find_axes(const film_vertex *v, const uint32_t corners[3], v3 axes[3])
{
    const v3 a = at(&v[corners[0]]);
    axes[0] = unit(less(at(&v[corners[1]]), a));
    axes[2] = unit(cross(axes[0], less(at(&v[corners[2]]), a)));
    axes[1] = cross(axes[2], axes[0]);
}

static uint32_t farthest(const film_model *m, v3 from, v3 line)
{
    uint32_t best = 0;
    double largest = -1.0;
    for (uint32_t i = 0; i < m->vertex_count; i++) {
        v3 offset = less(at(&m->vertices[i]), from);
        v3 off = dot(line, line) > 0.0 ? cross(line, offset) : offset;
        if (dot(off, off) > largest) {
            largest = dot(off, off);
            best = i;
        }
    }
    return best;
}

void film_find_corners(film_model *m)
{
    const v3 none = {0.0, 0.0, 0.0};
    v3 first = at(&m->vertices[0]);
    m->corners[0] = 0;
    m->corners[1] = farthest(m, first, none);
    m->corners[2] = farthest(m, first, less(at(&m->vertices[m->corners[1]]), first));
}

/* Shepperd (1978), Quaternion from rotation matrix: the largest of the four first. */
static void turn_of(double r[3][3], double q[4])
{
    const double trace = r[0][0] + r[1][1] + r[2][2];
    int largest = 0;
    for (int i = 0; i < 3; i++) {
        largest = r[i][i] > (largest == 0 ? trace : r[largest - 1][largest - 1]) ? i + 1 : largest;
    }
    if (largest == 0) {
        double s = sqrt(1.0 + trace);
        q[0] = 0.5 * s;
        q[1] = 0.5 * (r[2][1] - r[1][2]) / s;
        q[2] = 0.5 * (r[0][2] - r[2][0]) / s;
        q[3] = 0.5 * (r[1][0] - r[0][1]) / s;
        return;
    }
    const int i = largest - 1, j = (i + 1) % 3, k = (i + 2) % 3;
    double s = sqrt(1.0 + r[i][i] - r[j][j] - r[k][k]);
    q[0] = 0.5 * (r[k][j] - r[j][k]) / s;
    q[1 + i] = 0.5 * s;
    q[1 + j] = 0.5 * (r[j][i] + r[i][j]) / s;
    q[1 + k] = 0.5 * (r[k][i] + r[i][k]) / s;
}

void film_pose(const film_model *m, const film_vertex *vertices, double place[3], double turn[4])
{
    const uint32_t *c = m->corners;
    v3 was[3], is[3];
    double r[3][3];
    find_axes(m->vertices, c, was);
    find_axes(vertices, c, is);
    for (int k = 0; k < 3; k++) { /* the sum of is times was, turned into a row */
        const double now[3] = {is[k].x, is[k].y, is[k].z}, then[3] = {was[k].x, was[k].y, was[k].z};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                r[i][j] = (k == 0 ? 0.0 : r[i][j]) + now[i] * then[j];
            }
        }
    }
    turn_of(r, turn);
    v3 from = at(&m->vertices[c[0]]), to = at(&vertices[c[0]]);
    const double there[3] = {to.x, to.y, to.z};
    for (int i = 0; i < 3; i++) {
        place[i] = there[i] - (r[i][0] * from.x + r[i][1] * from.y + r[i][2] * from.z);
    }
}
