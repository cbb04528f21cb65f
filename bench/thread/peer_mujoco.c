/* Peer: MuJoCo, joint coordinates in double. The thread is a chain of rigid links with ball joints
 * that have springs of stiffness EI/l. Two methods:
 * - mujoco: the springs as MuJoCo has them, explicit in time.
 * - mujoco-damped: with joint damping in proportion to dt * EI/l, which MuJoCo takes implicitly. The
 *   torque then is, to first order, that of an angle later in the step: linearly implicit, stable
 *   at far larger steps, at the price of damped motion. */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <mujoco/mujoco.h>

#include "peer.h"

/* MuJoCo clips inertias at 1e-15: it is given millimetres and milligrams, where none is near. */
#define MM 1e3
#define MG 1e6

/* The XML parser takes no more than 100 nested elements, but included files are nested after they
 * are parsed: a longer chain comes in parts. */
enum { LINKS_PER_PART = 64, BYTES_PER_LINK = 256 };

/* Of the step, how much later that angle is. 1 is implicit Euler, 1/2 the limit of stability (it
 * fails at 5 ms): a little more than that damps the motion least. */
#define IMPLICIT_SHARE 0.55

typedef struct chain {
    mjModel *model;
    mjData *data;
    double length;     /* of a link, mm */
    double drag_decay; /* factor on the velocities in a step */
} chain;

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

/* The held first segment has no body: node 1 is the first joint, and link i ends at node i + 2. */
static void write_part(text *t, const cantilever_setup *setup, int links, int first, bool damped)
{
    double length = CANTILEVER_LENGTH / (setup->segments - 0.5);
    double stiffness = CANTILEVER_BENDING_STIFFNESS / length * MG * MM * MM;
    if (first == 0) {
        append(t, "<mujoco><option timestep='%.17g' gravity='0 %.17g 0' integrator='Euler'>",
               setup->dt, -CANTILEVER_GRAVITY * MM);
        append(t, "<flag constraint='disable' contact='disable'/></option>");
        append(t, "<default><joint type='ball' stiffness='%.17g' damping='%.17g'/></default>",
               stiffness, damped ? IMPLICIT_SHARE * setup->dt * stiffness : 0.0);
        append(t, "<worldbody>");
    } else {
        append(t, "<mujocoinclude>");
    }
    int end = first + LINKS_PER_PART < links ? first + LINKS_PER_PART : links;
    for (int i = first; i < end; i++) {
        double mass = CANTILEVER_LINEAR_DENSITY * length * MG * (i + 1 < links ? 1.0 : 0.5);
        /* A point mass at the far end lets the step be the largest; set_inertias sets the rest. */
        append(t, "<body pos='%.17g 0 0'><joint/>", length * MM * (i == 0 ? 0.5 : 1.0));
        append(t, "<inertial pos='%.17g 0 0' mass='%.17g' diaginertia='1 1 1'/>", length * MM,
               mass);
    }
    if (end < links) {
        append(t, "<include file='from%d.xml'/>", end);
    }
    for (int i = first; i < end; i++) {
        append(t, "</body>");
    }
    append(t, first == 0 ? "</worldbody></mujoco>" : "</mujocoinclude>");
}

static mjModel *load_parts(mjVFS *files, text *t, const cantilever_setup *setup, bool damped)
{
    int links = (int)setup->segments - 1;
    char name[32], error[256];
    for (int first = 0; first < links; first += LINKS_PER_PART) {
        t->size = 0;
        write_part(t, setup, links, first, damped);
        snprintf(name, sizeof name, "from%d.xml", first);
        if (mj_makeEmptyFileVFS(files, name, (int)t->size) != 0) {
            return NULL;
        }
        memcpy(files->filedata[mj_findFileVFS(files, name)], t->bytes, t->size);
    }
    return mj_loadXML("from0.xml", files, error, sizeof error);
}

static mjModel *load_model(const cantilever_setup *setup, bool damped)
{
    text t = {.room = (size_t)BYTES_PER_LINK * (LINKS_PER_PART + 4)};
    mjModel *model = NULL;
    mjVFS *files = malloc(sizeof *files); /* megabytes */
    t.bytes = malloc(t.room);
    if (files != NULL && t.bytes != NULL) {
        mj_defaultVFS(files);
        model = load_parts(files, &t, setup, damped);
        mj_deleteVFS(files);
        mj_freeLastXML();
    }
    free(t.bytes);
    free(files);
    return model;
}

/* No inertia but that of the point mass, save about the link's own axis: that takes no part in the
 * motion, and keeps the twist from limiting the step. */
static void set_inertias(chain *c)
{
    for (int body = 1; body < c->model->nbody; body++) {
        mjtNum *inertia = &c->model->body_inertia[3 * (size_t)body];
        inertia[0] = c->model->body_mass[body] * c->length * c->length;
        inertia[1] = inertia[2] = 0.0;
    }
    mj_setConst(c->model, c->data);
    mj_resetData(c->model, c->data);
}

/* Half a step back in velocity puts the velocities between the steps: leapfrog, of second order. */
static void set_velocities(chain *c)
{
    mj_forward(c->model, c->data);
    mju_scl(c->data->qvel, c->data->qacc, -0.5 * c->model->opt.timestep, c->model->nv);
}

static void ignore_warning(const char *message)
{
    (void)message; /* the default prints it and writes a file; step looks at the counts */
}

static void destroy(void *thread)
{
    chain *c = thread;
    if (c != NULL) {
        mj_deleteData(c->data);
        mj_deleteModel(c->model);
        free(c);
    }
}

static void *create(const cantilever_setup *setup, bool damped)
{
    mju_user_warning = ignore_warning;
    chain *c = setup->segments < 3 ? NULL : calloc(1, sizeof *c);
    if (c == NULL) {
        return NULL;
    }
    c->length = CANTILEVER_LENGTH / (setup->segments - 0.5) * MM;
    /* Drag proportional to mass decays all velocities alike, joint velocities included. */
    c->drag_decay = exp(-setup->drag * setup->dt);
    c->model = load_model(setup, damped);
    c->data = c->model != NULL ? mj_makeData(c->model) : NULL;
    if (c->data == NULL) {
        destroy(c);
        return NULL;
    }
    set_inertias(c);
    set_velocities(c);
    return c;
}

static void *create_explicit(const cantilever_setup *setup)
{
    return create(setup, false);
}

static void *create_damped(const cantilever_setup *setup)
{
    return create(setup, true);
}

static int step(void *thread)
{
    chain *c = thread;
    mj_step(c->model, c->data);
    if (c->drag_decay != 1.0) {
        mju_scl(c->data->qvel, c->data->qvel, c->drag_decay, c->model->nv);
    }
    /* MuJoCo counts a state gone bad and starts again from rest. */
    const mjWarningStat *warning = c->data->warning;
    return warning[mjWARN_BADQPOS].number + warning[mjWARN_BADQVEL].number +
                       warning[mjWARN_BADQACC].number >
                   0
               ? 1
               : 0;
}

static void tip(void *thread, double tip[3])
{
    chain *c = thread;
    mj_kinematics(c->model, c->data); /* mj_step leaves the places of the step's beginning */
    for (int k = 0; k < 3; k++) {
        tip[k] = c->data->xipos[3 * (c->model->nbody - 1) + k] / MM;
    }
}

static double stretch(void *thread)
{
    (void)thread;
    return 0.0;
}

/* The motion is bullet-multibody's to seven digits, and so are the limits. */
const cantilever_method cantilever_mujoco = {
    .name = "mujoco",
    .note = "MuJoCo " PEER_TEXT(mjVERSION_HEADER) ": rigid links, ball joints with springs EI/l,"
                                                  " explicit in time",
    .create = create_explicit,
    .step = step,
    .tip = tip,
    .stretch = stretch,
    .destroy = destroy,
    .largest_dt = {1e-3 / 1.1, 250e-6, 62.5e-6, 15.625e-6}};

/* By trial among 1, 2, 5, 10 and 20 ms: at 20 ms both tips are off by more than 1 mm. */
const cantilever_method cantilever_mujoco_damped = {
    .name = "mujoco-damped",
    .note = "MuJoCo " PEER_TEXT(mjVERSION_HEADER) ": as mujoco, and joint damping 0.55 dt EI/l,"
                                                  " implicit in time",
    .create = create_damped,
    .step = step,
    .tip = tip,
    .stretch = stretch,
    .destroy = destroy,
    .largest_dt = {10e-3, 10e-3, 10e-3, 10e-3}};
