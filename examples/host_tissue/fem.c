#include "fem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double tolerance = 1e-9; /* of the residual, relative to the first */
enum { MAX_ITERATIONS = 400 };

/* ---- matrix */

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Which of its neighbours node b is for node a. */
static int slot_of(const fem *f, int a, int b)
{
    const int layers = b / f->layer - a / f->layer;
    const int rows = b % f->layer / f->row - a % f->layer / f->row;
    return 9 * (layers + 1) + 3 * (rows + 1) + b % f->row - a % f->row + 1;
}

static int neighbour(const fem *f, int node, int slot)
{
    return node + (slot / 9 - 1) * f->layer + (slot / 3 % 3 - 1) * f->row + slot % 3 - 1;
}

/* Gradients of the shape functions; returns the volume. */
static double gradients_of(const fem *f, const int n[4], double g[4][3])
{
    double e[3][3];
    memset(g, 0, 12 * sizeof g[0][0]);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            e[i][k] = f->rest[n[i + 1]][k] - f->rest[n[0]][k];
        }
    }
    for (int i = 0; i < 3; i++) { /* times six volumes */
        cross(e[(i + 1) % 3], e[(i + 2) % 3], g[i + 1]);
    }
    const double six = e[0][0] * g[1][0] + e[0][1] * g[1][1] + e[0][2] * g[1][2];
    for (int k = 0; k < 3; k++) {
        for (int i = 1; i < 4; i++) {
            g[i][k] /= six;
            g[0][k] -= g[i][k];
        }
    }
    return fabs(six) / 6.0;
}

/* Adds the stiffness and mass of a tetrahedron: V (lambda g_i g_j + mu (g_j g_i + (g_i . g_j) I)). */
static void add_tetrahedron(fem *f, const int n[4])
{
    const fem_config *c = &f->config;
    const double lambda = c->young * c->poisson / ((1.0 + c->poisson) * (1.0 - 2.0 * c->poisson));
    const double mu = 0.5 * c->young / (1.0 + c->poisson);
    double g[4][3];
    const double volume = gradients_of(f, n, g);
    for (int i = 0; i < 4; i++) {
        f->mass[n[i]] += 0.25 * c->density * volume;
        for (int j = 0; j < 4; j++) {
            const int slot = slot_of(f, n[i], n[j]);
            double *block = f->stiffness[n[i]][slot];
            f->is_coupled[n[i]][slot] = 1;
            const double dot = g[i][0] * g[j][0] + g[i][1] * g[j][1] + g[i][2] * g[j][2];
            for (int k = 0; k < 9; k++) {
                const int a = k / 3, b = k % 3;
                block[k] += volume * (lambda * g[i][a] * g[j][b] +
                                      mu * (g[j][a] * g[i][b] + (a == b ? dot : 0.0)));
            }
        }
    }
}

static void build(fem *f)
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const int *cells = f->config.cells, step[3] = {f->row, f->layer, 1};
    for (int i = 0; i < f->nodes; i++) {
        const int x = i % f->layer / f->row, y = i / f->layer;
        f->rest[i][0] = f->config.side * (x - 0.5 * cells[0]);
        f->rest[i][1] = f->config.side * (y - cells[1]);
        f->rest[i][2] = f->config.side * (i % f->row - 0.5 * cells[2]);
    }
    for (int cell = 0; cell < cells[0] * cells[1] * cells[2]; cell++) {
        const int first = cell / (cells[0] * cells[2]) * f->layer +
                          cell % (cells[0] * cells[2]) / cells[2] * f->row + cell % cells[2];
        for (int k = 0; k < 6; k++) { /* six tetrahedra along the diagonal of a cell */
            int n[4] = {first, 0, 0, 0};
            for (int i = 0; i < 3; i++) {
                n[i + 1] = n[i] + step[axes[k][i]];
            }
            add_tetrahedron(f, n);
        }
    }
}

/* Row of the stiffness matrix times x: the opposite of the elastic force. */
static void multiply_row(const fem *f, int node, const double (*x)[3], double out[3])
{
    out[0] = out[1] = out[2] = 0.0;
    for (int s = 0; s < FEM_NEIGHBOURS; s++) {
        const double *b = f->stiffness[node][s];
        if (!f->is_coupled[node][s]) {
            continue;
        }
        const double *y = x[neighbour(f, node, s)];
        for (int k = 0; k < 3; k++) {
            const double *row = b + 3 * (size_t)k;
            out[k] += row[0] * y[0] + row[1] * y[1] + row[2] * y[2];
        }
    }
}

/* ---- steps */

static double inertia(const fem *f, int node)
{
    return f->mass[node] * (1.0 / f->config.h + f->config.damping) / f->config.h;
}

/* (inertia + stiffness) x, of nodes that are not fixed. */
static void multiply(const fem *f, const double (*x)[3], double (*out)[3])
{
    for (int i = f->layer; i < f->nodes; i++) {
        multiply_row(f, i, x, out[i]);
        for (int k = 0; k < 3; k++) {
            out[i][k] += inertia(f, i) * x[i][k];
        }
    }
}

/* Product of two vectors; with the inverse of the matrix's diagonal between them, if that is wanted. */
static double dot(const fem *f, const double (*a)[3], const double (*b)[3], int is_scaled)
{
    double sum = 0.0;
    for (int i = f->layer; i < f->nodes; i++) {
        for (int k = 0; k < 3; k++) {
            const double diagonal =
                f->stiffness[i][FEM_NEIGHBOURS / 2][4 * (size_t)k] + inertia(f, i);
            sum += a[i][k] * b[i][k] / (is_scaled ? diagonal : 1.0);
        }
    }
    return sum;
}

/* Solves (inertia + stiffness) solution = residual by conjugate gradients with the diagonal, from zero. */
static void solve(fem *f)
{
    double(*x)[3] = f->solution, (*r)[3] = f->residual, (*p)[3] = f->direction,
    (*q)[3] = f->product;
    const double(*fixed_r)[3] = (const double(*)[3])r, (*fixed_p)[3] = (const double(*)[3])p;
    const double first = dot(f, fixed_r, fixed_r, 0);
    double rho = 0.0;
    memset(x, 0, (size_t)f->nodes * sizeof *x);
    memset(p, 0, (size_t)f->nodes * sizeof *p);
    for (int iteration = 0; iteration < MAX_ITERATIONS; iteration++) {
        if (dot(f, fixed_r, fixed_r, 0) <= tolerance * tolerance * first) {
            return;
        }
        const double fresh = dot(f, fixed_r, fixed_r, 1);
        for (int i = f->layer; i < f->nodes; i++) {
            for (int k = 0; k < 3; k++) {
                const double diagonal =
                    f->stiffness[i][FEM_NEIGHBOURS / 2][4 * (size_t)k] + inertia(f, i);
                p[i][k] = r[i][k] / diagonal + (iteration == 0 ? 0.0 : fresh / rho * p[i][k]);
            }
        }
        rho = fresh;
        multiply(f, fixed_p, q);
        const double length = rho / dot(f, fixed_p, (const double(*)[3])q, 0);
        for (int i = f->layer; i < f->nodes; i++) {
            for (int k = 0; k < 3; k++) {
                x[i][k] += length * p[i][k];
                r[i][k] -= length * q[i][k];
            }
        }
    }
}

void fem_predict(fem *f, double (*surface)[3])
{
    const double h = f->config.h;
    for (int i = f->layer; i < f->nodes; i++) {
        for (int k = 0; k < 3; k++) {
            f->residual[i][k] = inertia(f, i) * f->u[i][k] + f->mass[i] * f->v[i][k] / h;
        }
    }
    solve(f);
    memcpy(f->next, f->solution, (size_t)f->nodes * sizeof *f->next);
    for (int i = f->first_surface; i < f->nodes; i++) {
        for (int k = 0; k < 3; k++) {
            surface[i - f->first_surface][k] = f->rest[i][k] + f->next[i][k];
        }
    }
}

static void load_surface(fem *f, const double (*forces)[3])
{
    memset(f->residual, 0, (size_t)f->nodes * sizeof *f->residual);
    memcpy(f->residual[f->first_surface], forces, (size_t)f->layer * sizeof *forces);
}

void fem_apply(fem *f, const double (*forces)[3])
{
    load_surface(f, forces);
    solve(f);
    for (int i = f->layer; i < f->nodes; i++) {
        for (int k = 0; k < 3; k++) {
            const double next = f->next[i][k] + f->solution[i][k];
            f->v[i][k] = (next - f->u[i][k]) / f->config.h;
            f->u[i][k] = next;
        }
    }
}

/* ---- what the scene and the report ask */

void fem_compliance(fem *f, int vertex, int alone, double block[9])
{
    const int node = f->first_surface + vertex;
    double found[3][3];
    for (int i = 0; i < 3; i++) { /* columns of the inverse */
        memset(f->residual, 0, (size_t)f->nodes * sizeof *f->residual);
        f->residual[node][i] = 1.0;
        solve(f);
        int count = 0;
        double mean[3] = {0.0, 0.0, 0.0};
        for (int s = 9; s < 18; s++) { /* of its own layer */
            const int other = neighbour(f, node, s);
            for (int k = 0; k < 3 && s != FEM_NEIGHBOURS / 2 && f->is_coupled[node][s]; k++) {
                count += k == 0;
                mean[k] += f->solution[other][k];
            }
        }
        for (int k = 0; k < 3; k++) {
            found[k][i] =
                f->solution[node][k] + (alone || count == 0 ? 0.0 : 2.0 * mean[k] / count);
        }
    }
    for (int i = 0; i < 9; i++) { /* exactly symmetric */
        block[i] = 0.5 * (found[i / 3][i % 3] + found[i % 3][i / 3]);
    }
}

void fem_elastic_force(const fem *f, int vertex, double force[3])
{
    multiply_row(f, f->first_surface + vertex, (const double(*)[3])f->u, force);
    for (int k = 0; k < 3; k++) {
        force[k] = -force[k];
    }
}

void fem_reaction(const fem *f, double force[3])
{
    force[0] = force[1] = force[2] = 0.0;
    for (int i = 0; i < f->layer; i++) {
        double row[3];
        multiply_row(f, i, (const double(*)[3])f->u, row);
        for (int k = 0; k < 3; k++) {
            force[k] -= row[k];
        }
    }
}

/* ---- life */

int fem_create(fem *f, const fem_config *config)
{
    memset(f, 0, sizeof *f);
    f->config = *config;
    f->row = config->cells[2] + 1;
    f->layer = (config->cells[0] + 1) * f->row;
    f->nodes = f->layer * (config->cells[1] + 1);
    f->first_surface = f->nodes - f->layer;
    const size_t n = (size_t)f->nodes;
    double(**vectors[])[3] = {&f->rest,     &f->u,        &f->v,         &f->next,
                              &f->solution, &f->residual, &f->direction, &f->product};
    int good = 1;
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        *vectors[i] = calloc(n, sizeof **vectors[i]);
        good = good && *vectors[i] != NULL;
    }
    f->mass = calloc(n, sizeof *f->mass);
    f->stiffness = calloc(n, sizeof *f->stiffness);
    f->is_coupled = calloc(n, sizeof *f->is_coupled);
    if (!good || f->is_coupled == NULL || f->mass == NULL || f->stiffness == NULL) {
        fem_destroy(f);
        return 0;
    }
    build(f);
    return 1;
}

void fem_destroy(fem *f)
{
    void *all[] = {f->rest,      f->u,       f->v,    f->next,      f->solution,  f->residual,
                   f->direction, f->product, f->mass, f->stiffness, f->is_coupled};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        free(all[i]);
    }
    memset(f, 0, sizeof *f);
}
