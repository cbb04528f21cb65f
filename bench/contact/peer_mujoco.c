/* Peer: MuJoCo. The thread is a row of rigid capsules, bodies of their own that `connect`
 * constraints join end to end, with elliptic friction cones; Newton's method, sparse.
 *
 * Chosen by trial, in its favour:
 * - Free bodies rather than a tree of ball joints, the usual chain (and the cantilever's): a tree's
 *   mass matrix fills, 0.6 ms a step without contact at 61 nodes against 0.13 ms, and it lost the
 *   knot with steps of 1/8 to 1/32 ms, however its joints were damped.
 * - Turning inertia: links that turn explicitly in time under a tension T shake themselves to pieces
 *   above T = linear density * l^2 / h^2, 6 mN at 61 nodes and 1/4 ms. Each link is given h^2 l T
 *   more (`armature`), four times the limit, and a drag that takes nine tenths of its turning a
 *   step. That makes torques explicit in time stable, too: MuJoCo has no springs between free bodies,
 *   so EI comes as an applied force. The price is a tension that reads too high while the knot runs
 *   in, in proportion to the step. Damping instead, which MuJoCo takes implicitly, fails:
 *   it enters after the constraints are solved, and tears them.
 * - MuJoCo caps how hard constraints are (impedance 0.9999), in proportion to the bodies' inertia: links
 *   part by 1 to 30 %. The inertia it assumes for that is set such that a connect is a spring of
 *   EA / l. Contacts, impedance 0.999, are then springs of EA / (10 l).
 * - Time constants 2 h, the shortest it allows; tolerance 1e-4: below it little but the time grows.
 *   impratio 10 gained little; the noslip solver blew up.
 * - Millimetres, milligrams, milliseconds, where none of its smallest numbers is near.
 * This version has neither the composite `cable` nor implicitfast. */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <mujoco/mujoco.h>

#include "peer.h"

#define MM 1e3          /* in a metre */
#define MG 1e6          /* in a kilogram */
#define MS 1e3          /* in a second */
#define MILLINEWTON 1e3 /* in a newton: mg mm/ms^2 */

/* The impedances of a connect and of a contact. */
#define JOINED 0.9999
#define TOUCHING 0.999
/* Times the step: the constraints' time constant. */
#define TIME_CONSTANT 2.0
/* Of its turning, what a link loses in a step. */
#define TURNING_LOST 0.9
/* Nearer along the thread than this many diameters segments may touch: a bend is no contact. */
#define BEND 1.6

enum { BYTES_PER_LINK = 1024, CONTACTS_PER_LINK = 4 };

typedef struct row {
    mjModel *model;
    mjData *data;
    size_t links;
    double *lengths, *turning_inertia; /* mm, mg mm^2: each link's, added to its own */
    double bending_stiffness, dt;      /* mN mm^2, ms */
    double ends[2][3];                 /* mm */
    double tension;                    /* N */
} row;

/* ---- the model, as text */

typedef struct text {
    char *bytes;
    size_t size, room;
} text;

static void append(text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(t->bytes + t->size, t->room - t->size, format, arguments);
    va_end(arguments);
    t->size += n > 0 && (size_t)n < t->room - t->size ? (size_t)n : 0;
}

static void write_options(text *t, const row *r, const contact_peer_scene *s)
{
    size_t contacts = CONTACTS_PER_LINK * r->links;
    append(t, "<mujoco><size nconmax='%zu' njmax='%zu'/>", contacts, 3 * (r->links + 1 + contacts));
    append(t,
           "<option timestep='%.17g' gravity='0 0 0' integrator='Euler' cone='elliptic'"
           " solver='Newton' iterations='50' tolerance='1e-4' jacobian='sparse'/>",
           r->dt);
    append(t,
           "<default><geom type='capsule' size='%.17g' condim='3' friction='%.17g 0 0'"
           " solref='%.17g 1' solimp='%g %g'/>",
           0.5 * s->diameter * MM, s->friction, TIME_CONSTANT * r->dt, TOUCHING, TOUCHING);
    append(t, "<equality solref='%.17g 1' solimp='%g %g'/></default>", TIME_CONSTANT * r->dt,
           JOINED, JOINED);
}

/* In a line, as the model's rest pose; half of each link's mass is at each of its ends. */
static void write_links(text *t, const row *r, const contact_peer_scene *s)
{
    double at = 0.0;
    append(t, "<worldbody>");
    for (size_t i = 0; i < r->links; i++) {
        double half = 0.5 * r->lengths[i];
        double mass = s->linear_density / MM * MG * r->lengths[i], inertia = mass * half * half;
        append(t, "<body name='%zu' pos='%.17g 0 0'><freejoint/>", i, at + half);
        append(t, "<inertial pos='0 0 0' mass='%.17g' diaginertia='%.17g %.17g %.17g'/>", mass,
               inertia, inertia, inertia);
        append(t, "<geom fromto='%.17g 0 0 %.17g 0 0'/></body>", -half, half);
        at += r->lengths[i];
    }
    append(t, "</worldbody>");
}

static void write_neighbours(text *t, const row *r, const contact_peer_scene *s)
{
    append(t, "<contact>");
    for (size_t i = 0; i < r->links; i++) {
        double between = 0.0;
        for (size_t j = i + 1; j < r->links && between < BEND * s->diameter * MM; j++) {
            append(t, "<exclude body1='%zu' body2='%zu'/>", i, j);
            between += r->lengths[j];
        }
    }
    append(t, "</contact>");
}

/* The thread's two ends first, tied to the world. */
static void write_connects(text *t, const row *r)
{
    size_t last = r->links - 1;
    append(t, "<equality><connect body1='0' anchor='%.17g 0 0'/>", -0.5 * r->lengths[0]);
    append(t, "<connect body1='%zu' anchor='%.17g 0 0'/>", last, 0.5 * r->lengths[last]);
    for (size_t i = 0; i < last; i++) {
        append(t, "<connect body1='%zu' body2='%zu' anchor='%.17g 0 0'/>", i, i + 1,
               0.5 * r->lengths[i]);
    }
    append(t, "</equality></mujoco>");
}

static mjModel *load_model(const row *r, const contact_peer_scene *s)
{
    char error[256];
    text t = {.room = BYTES_PER_LINK * (r->links + 4)};
    mjModel *model = NULL;
    mjVFS *files = malloc(sizeof *files); /* megabytes */
    t.bytes = malloc(t.room);
    if (files != NULL && t.bytes != NULL) {
        mj_defaultVFS(files);
        write_options(&t, r, s);
        write_links(&t, r, s);
        write_neighbours(&t, r, s);
        write_connects(&t, r);
        if (mj_makeEmptyFileVFS(files, "thread.xml", (int)t.size) == 0) {
            memcpy(files->filedata[mj_findFileVFS(files, "thread.xml")], t.bytes, t.size);
            model = mj_loadXML("thread.xml", files, error, sizeof error);
        }
        mj_deleteVFS(files);
        mj_freeLastXML();
    }
    free(t.bytes);
    free(files);
    return model;
}

/* ---- what the text cannot say. Link i is body i + 1, and its three turning dofs come last. */

static void set_inertias(row *r, const contact_peer_scene *s)
{
    for (size_t i = 0; i < r->links; i++) {
        r->turning_inertia[i] = r->dt * r->dt * r->lengths[i] * s->tension * MILLINEWTON;
        for (size_t k = 3; k < 6; k++) {
            r->model->dof_armature[6 * i + k] = r->turning_inertia[i];
        }
    }
    mj_setConst(r->model, r->data);
    mj_resetData(r->model, r->data);
    /* A constraint at rest is a spring of stiffness / R, R = (1 - impedance) / impedance times the
     * sum of both bodies' inverse inertias: half of a segment's compliance comes from each. */
    double time = JOINED * TIME_CONSTANT * r->dt;
    for (size_t i = 0; i < r->links; i++) {
        double compliance = 0.5 * r->lengths[i] / (s->stretch_stiffness * MILLINEWTON);
        r->model->body_invweight0[2 * (i + 1)] =
            compliance / (time * time) * JOINED / (1.0 - JOINED);
    }
}

/* The least rotation that turns direction a into b, both of length one. */
static void min_rotation(mjtNum q[4], const double a[3], const double b[3])
{
    mju_cross(q + 1, a, b);
    q[0] = 1.0 + mju_dot3(a, b);
    mju_normalize4(q);
}

/* Where in the world the two ends are tied. */
static void hold_ends(row *r, const double *first, const double *last)
{
    mju_copy3(r->model->eq_data + 3, first);
    mju_copy3(r->model->eq_data + mjNEQDATA + 3, last);
}

/* Without twist from each link to the next. */
static void set_places(row *r, const double *positions)
{
    double along[3] = {1, 0, 0}, next[3];
    mjtNum turn[4] = {1, 0, 0, 0}, by[4];
    for (size_t i = 0; i < r->links; i++) {
        const double *from = &positions[3 * i];
        mjtNum *q = r->data->qpos + 7 * i;
        mju_sub3(next, from + 3, from);
        mju_normalize3(next);
        min_rotation(by, along, next);
        mju_mulQuat(q + 3, by, turn);
        mju_copy4(turn, q + 3);
        mju_copy3(along, next);
        mju_add3(q, from, from + 3);
        mju_scl3(q, q, 0.5 * MM);
    }
    mju_scl3(r->ends[0], positions, MM);
    mju_scl3(r->ends[1], positions + 3 * r->links, MM);
    hold_ends(r, r->ends[0], r->ends[1]);
    mj_kinematics(r->model, r->data);
}

/* ---- the peer */

static void ignore_warning(const char *message)
{
    (void)message; /* the default prints it and writes a file; step looks at the counts */
}

static void destroy(void *peer)
{
    row *r = peer;
    if (r != NULL) {
        mj_deleteData(r->data);
        mj_deleteModel(r->model);
        free(r->turning_inertia);
        free(r->lengths);
        free(r);
    }
}

static void *create(const contact_peer_scene *scene, size_t nodes, const double *positions,
                    double step)
{
    mju_user_warning = ignore_warning;
    row *r = nodes < 3 ? NULL : calloc(1, sizeof *r);
    if (r == NULL) {
        return NULL;
    }
    r->links = nodes - 1;
    r->dt = step * MS;
    r->bending_stiffness = scene->bending_stiffness * MILLINEWTON * MM * MM;
    r->lengths = calloc(r->links, sizeof *r->lengths);
    r->turning_inertia = calloc(r->links, sizeof *r->turning_inertia);
    if (r->lengths != NULL && r->turning_inertia != NULL) {
        for (size_t i = 0; i < r->links; i++) {
            r->lengths[i] = MM * mju_dist3(&positions[3 * i], &positions[3 * i + 3]);
        }
        r->model = load_model(r, scene);
    }
    r->data = r->model != NULL ? mj_makeData(r->model) : NULL;
    if (r->data == NULL) {
        destroy(r);
        return NULL;
    }
    set_inertias(r, scene);
    set_places(r, positions);
    return r;
}

/* EI / l times the rotation vector from each link to the next, whose components are the same in
 * both links' frames; twist has the same stiffness. And the drag. */
static void apply_torques(row *r)
{
    mjtNum *force = r->data->qfrc_applied, back[4], turn[4], torque[3];
    for (size_t i = 0; i < r->links; i++) {
        double drag = TURNING_LOST / r->model->opt.timestep * r->turning_inertia[i];
        mju_scl3(force + 6 * i + 3, r->data->qvel + 6 * i + 3, -drag);
    }
    for (size_t i = 0; i + 1 < r->links; i++) {
        const mjtNum *q = r->data->qpos + 7 * i + 3;
        mju_negQuat(back, q);
        mju_mulQuat(turn, back, q + 7);
        mju_quat2Vel(torque, turn, 1.0);
        double stiffness = 2.0 * r->bending_stiffness / (r->lengths[i] + r->lengths[i + 1]);
        mju_addToScl3(force + 6 * i + 3, torque, stiffness);
        mju_addToScl3(force + 6 * i + 9, torque, -stiffness);
    }
}

static int step(void *peer, const double end_a[3], const double end_b[3], double h)
{
    row *r = peer;
    const double *to[2] = {end_a, end_b};
    double at[2][3];
    int steps = (int)ceil(h * MS / r->dt - 1e-9);
    r->model->opt.timestep = h * MS / steps;
    r->tension = 0.0;
    for (int i = 1; i <= steps; i++) {
        for (int e = 0; e < 2; e++) {
            for (int k = 0; k < 3; k++) {
                at[e][k] = r->ends[e][k] + (to[e][k] * MM - r->ends[e][k]) * i / steps;
            }
        }
        hold_ends(r, at[0], at[1]);
        apply_torques(r);
        mj_step(r->model, r->data);
        /* The ends' three rows each come first. */
        const mjtNum *force = r->data->efc_force;
        r->tension += 0.5 * (mju_norm3(force) + mju_norm3(force + 3)) / steps / MILLINEWTON;
    }
    memcpy(r->ends, at, sizeof at);
    mj_kinematics(r->model, r->data); /* mj_step leaves the places of the step's beginning */
    int warnings =
        0; /* MuJoCo counts a state gone bad and starts again; full: contacts were lost */
    for (int i = 0; i < mjNWARNING; i++) {
        warnings += r->data->warning[i].number;
    }
    return warnings > 0 ? 1 : 0;
}

/* Links that were joined at a node may stand a little apart: the middle. */
static size_t read_nodes(void *peer, double *positions)
{
    row *r = peer;
    mju_zero(positions, (int)(3 * (r->links + 1)));
    for (size_t i = 0; i < r->links; i++) {
        const mjtNum *centre = r->data->xpos + 3 * (i + 1), *frame = r->data->xmat + 9 * (i + 1);
        double before = i == 0 ? 1.0 : 0.5, after = i + 1 == r->links ? 1.0 : 0.5;
        for (size_t k = 0; k < 3; k++) {
            double half = 0.5 * r->lengths[i] * frame[3 * k];
            positions[3 * i + k] += before * (centre[k] - half) / MM;
            positions[3 * i + 3 + k] += after * (centre[k] + half) / MM;
        }
    }
    return r->links + 1;
}

static double tension(void *peer)
{
    return ((row *)peer)->tension;
}

/* Of 1, 1/2, ... 1/16 ms. */
const contact_peer contact_mujoco = {
    .name = "mujoco",
    .note = "MuJoCo " PEER_TEXT(mjVERSION_HEADER) ": capsules joined by connects, elliptic friction"
                                                  " cones, Newton; turning inertia added",
    .create = create,
    .step = step,
    .read = read_nodes,
    .tension = tension,
    .destroy = destroy,
    .best_step = {0.25e-3, 0.25e-3, 0.25e-3}};
