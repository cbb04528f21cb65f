/* A host with tissue of its own: linear tetrahedra, implicit steps, and a scene that lays a taut thread over them.
 *
 * In each step the host computes where its nodes go without the thread, gives the surface to the scene, and then applies the
 * forces that the scene returns. How far a vertex gives way to a force in a step, a block of 3 x 3 of the inverse of the
 * host's matrix, goes to the scene once: without it a light surface is not stable. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

enum { NX = 8, NY = 2, NZ = 8, ROW = NZ + 1, LAYER = (NX + 1) * ROW, NODES = LAYER * (NY + 1) };
enum { FREE = NODES - LAYER, SIZE = 3 * FREE }; /* the lowest layer, the first nodes, is fixed */
static const double side = 5e-3, young = 20e3, poisson = 0.4, density = 1000.0, damping = 20.0,
                    h = 1e-3;

static double rest[NODES][3], mass[NODES],
    matrix[SIZE][SIZE]; /* stiffness, then its Cholesky factor */

/* ---- tissue */

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Adds the stiffness and mass of a tetrahedron: V (lambda g_i g_j + mu (g_j g_i + (g_i . g_j) I)). */
static void add_tetrahedron(const int n[4])
{
    const double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    const double mu = 0.5 * young / (1.0 + poisson);
    double e[3][3], g[4][3] = {{0.0}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            e[i][k] = rest[n[i + 1]][k] - rest[n[0]][k];
        }
    }
    for (int i = 0; i < 3; i++) { /* gradients of the shape functions, times six volumes */
        cross(e[(i + 1) % 3], e[(i + 2) % 3], g[i + 1]);
    }
    const double six = e[0][0] * g[1][0] + e[0][1] * g[1][1] + e[0][2] * g[1][2];
    for (int k = 0; k < 3; k++) {
        for (int i = 1; i < 4; i++) {
            g[i][k] /= six;
            g[0][k] -= g[i][k];
        }
    }
    for (int i = 0; i < 4; i++) {
        mass[n[i]] += density * fabs(six) / 24.0;
        for (int j = 0; j < 4 && n[i] >= LAYER; j++) {
            const double dot = g[i][0] * g[j][0] + g[i][1] * g[j][1] + g[i][2] * g[j][2];
            for (int k = 0; k < 9 && n[j] >= LAYER; k++) {
                const int a = k / 3, b = k % 3;
                matrix[3 * (n[i] - LAYER) + a][3 * (n[j] - LAYER) + b] +=
                    fabs(six) / 6.0 *
                    (lambda * g[i][a] * g[j][b] + mu * (g[j][a] * g[i][b] + (a == b ? dot : 0.0)));
            }
        }
    }
}

static void build_tissue(void)
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const int step[3] = {ROW, LAYER, 1}; /* to the next node along x, y, z */
    for (int i = 0; i < NODES; i++) {
        const int row = i % LAYER / ROW, layer = i / LAYER;
        rest[i][0] = side * (row - 0.5 * NX);
        rest[i][1] = side * (layer - NY);
        rest[i][2] = side * (i % ROW - 0.5 * NZ);
    }
    for (int cell = 0; cell < NX * NY * NZ; cell++) {
        const int first = cell / (NX * NZ) * LAYER + cell % (NX * NZ) / NZ * ROW + cell % NZ;
        for (int k = 0; k < 6; k++) { /* six tetrahedra along the diagonal of a cell */
            int n[4] = {first, 0, 0, 0};
            for (int i = 0; i < 3; i++) {
                n[i + 1] = n[i] + step[axes[k][i]];
            }
            add_tetrahedron(n);
        }
    }
    for (int i = 0; i < SIZE; i++) {
        matrix[i][i] += mass[LAYER + i / 3] * (1.0 / h + damping) / h;
    }
    for (int i = 0; i < SIZE; i++) { /* Cholesky */
        for (int j = 0; j <= i; j++) {
            double sum = matrix[i][j];
            for (int k = 0; k < j; k++) {
                sum -= matrix[i][k] * matrix[j][k];
            }
            matrix[i][j] = i == j ? sqrt(sum) : sum / matrix[j][j];
        }
    }
}

static void solve(double b[SIZE])
{
    for (int i = 0; i < SIZE; i++) {
        for (int k = 0; k < i; k++) {
            b[i] -= matrix[i][k] * b[k];
        }
        b[i] /= matrix[i][i];
    }
    for (int i = SIZE - 1; i >= 0; i--) {
        for (int k = i + 1; k < SIZE; k++) {
            b[i] -= matrix[k][i] * b[k];
        }
        b[i] /= matrix[i][i];
    }
}

/* ---- scene */

static void check(vbss_context *context, vbss_result result)
{
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(context, NULL, &text);
        fprintf(stderr, "%s: %s\n", vbss_result_name(result), text);
        exit(1);
    }
}

static uint32_t add_surface(vbss_context *context, vbss_scene *scene)
{
    uint32_t triangles[2 * NX * NZ][3], body;
    static double compliance[LAYER][3][3], unit[SIZE];
    for (uint32_t i = 0; i < NX * NZ; i++) {
        const uint32_t a = i / NZ * ROW + i % NZ, b = a + ROW;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[2 * (size_t)i], cell, sizeof cell);
    }
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = LAYER;
    config.triangle_count = 2 * NX * NZ;
    config.vertices = rest[NODES - LAYER];
    config.triangles = triangles[0];
    config.friction = 0.1;
    config.compliance_size = 9;
    check(context, vbss_scene_add_surface(scene, &config, &body));
    for (int i = 0; i < 3 * LAYER; i++) { /* columns of the inverse */
        memset(unit, 0, sizeof unit);
        unit[SIZE - 3 * LAYER + i] = 1.0;
        solve(unit);
        for (int k = 0; k < 3; k++) {
            compliance[i / 3][i % 3][k] = unit[SIZE - 3 * LAYER + i / 3 * 3 + k];
        }
    }
    for (int i = 0; i < LAYER; i++) { /* exactly symmetric */
        for (int k = 0; k < 3; k++) {
            compliance[i][(k + 1) % 3][k] = compliance[i][k][(k + 1) % 3];
        }
    }
    check(context, vbss_scene_set_surface_compliance(scene, body, compliance[0][0], 9 * LAYER));
    return body;
}

/* A thread across the tissue, beyond both sides of it, whose ends are drawn down by 50 mN each. */
static void add_thread(vbss_context *context, vbss_scene *scene)
{
    vbss_thread_config config = vbss_thread_config_default();
    vbss_thread_attachment pull;
    vbss_thread *thread;
    uint32_t body, id;
    config.length = 60e-3;
    config.segment_count = 60;
    config.start[0] = -30e-3;
    config.start[1] = 0.5e-3;
    config.start[2] = 1e-3;
    check(context, vbss_thread_create(context, &config, &thread));
    check(context, vbss_scene_add_thread(scene, thread, &body));
    for (uint32_t end = 0; end < 2; end++) {
        check(context, vbss_thread_attachment_init(&pull, sizeof pull));
        pull.kind = VBSS_THREAD_ATTACHMENT_MASS;
        pull.node = end * config.segment_count;
        pull.mass = 1e-3;
        check(context, vbss_thread_attach(thread, &pull, &id));
        pull.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        pull.force[1] = -50e-3;
        check(context, vbss_thread_attach(thread, &pull, &id));
    }
}

int main(void)
{
    static double u[SIZE], v[SIZE], b[SIZE], vertices[LAYER][3];
    vbss_context *context;
    vbss_scene *scene;
    vbss_scene_config config = vbss_scene_config_default();
    (void)setlocale(LC_NUMERIC, "C");      /* numbers with a decimal point */
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* each call finishes its step */
    check(NULL, vbss_context_create(NULL, &context));
    check(context, vbss_scene_create(context, &config, &scene));
    build_tissue();
    const uint32_t surface = add_surface(context, scene);
    add_thread(context, scene);
    double apart = 0.0, deepest = 0.0, force = 0.0;
    for (int step = 0; step < 1000; step++) {
        for (int i = 0; i < SIZE; i++) { /* where the tissue goes without contact */
            b[i] = mass[LAYER + i / 3] * ((1.0 / h + damping) * u[i] + v[i]) / h;
        }
        solve(b);
        for (int i = 0; i < 3 * LAYER; i++) {
            vertices[i / 3][i % 3] = rest[NODES - LAYER + i / 3][i % 3] + b[SIZE - 3 * LAYER + i];
        }
        check(context, vbss_scene_move_surface(scene, surface, vertices[0], LAYER));
        check(context, vbss_scene_step(scene, h));
        vbss_view forces, positions;
        check(context, vbss_scene_get_surface_view(scene, surface, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                                   &forces, sizeof forces));
        check(context,
              vbss_scene_get_surface_view(scene, surface, VBSS_SCENE_SURFACE_VIEW_POSITIONS,
                                          &positions, sizeof positions));
        static double c[SIZE];
        memset(c, 0, sizeof c);
        memcpy(c + SIZE - 3 * (size_t)LAYER, forces.data, 3 * (size_t)LAYER * sizeof *c);
        solve(c);
        apart = deepest = force = 0.0;
        for (int i = 0; i < SIZE; i++) {
            const double next = b[i] + c[i];
            v[i] = (next - u[i]) / h;
            u[i] = next;
        }
        for (int i = 0; i < LAYER; i++) {
            const double *x = (const double *)positions.data + 3 * (size_t)i;
            const double own = rest[NODES - LAYER + i][1] + u[SIZE - 3 * LAYER + 3 * i + 1];
            apart = fmax(apart, fabs(x[1] - own));
            deepest = fmin(deepest, own);
            force += ((const double *)forces.data)[3 * i + 1];
        }
    }
    printf("force on the tissue %.4f N, deepest %.3f mm, host and scene apart by %.4f mm\n", force,
           1e3 * deepest, 1e3 * apart);
    check(context, vbss_context_destroy(context));
    return 0;
}
