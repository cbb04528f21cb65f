/* The contract of drains. */
#include <stdlib.h>

#include "fixtures/baseline_of.h"
#include "base/config.h"
#include "base/error.h"
#include "contract/contract.h"
#include "drain/drain.h"

/* ---- scripted runs: hands pull until parts of the strip have torn off, then let go */

typedef struct pulled {
    double tear_stress;
    uint32_t linearisations;
    vbss_drain_mesh mesh;
} pulled;

static vbss_result pulled_create(vbss_context *context, void *user, void **handle)
{
    const pulled *p = user;
    vbss_drain_config config;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.tear_stress = p->tear_stress;
    config.iteration_limit = p->linearisations;
    config.mesh = p->mesh;
    config.gravity[1] = -9.81;
    config.move_limit = 3e-4; /* so that steps are divided */
    return vbss_drain_create(context, &config, (vbss_drain **)handle);
}

static vbss_result attach(vbss_drain *drain, vbss_drain_attachment_kind kind, uint32_t node)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.position[1] = 7e-3;
    a.force[2] = 5e-3;
    a.stiffness = 5.0;
    return vbss_drain_attach(drain, &a, &id);
}

static vbss_result pulled_step(void *handle)
{
    vbss_drain_statistics s;
    vbss_drain_places p;
    VBSS_TRY(vbss_drain_get_statistics(handle, &s, sizeof s));
    VBSS_TRY(vbss_drain_get_places(handle, &p, sizeof p));
    double t = 1e-3 * (double)s.steps;
    if (s.steps == 0) {
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_PIN, p.marks[0]));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_FORCE, p.gap_points[1]));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_SPRING, p.gap_points[0]));
    }
    if (s.steps < 60) {
        const double to[3] = {0.1 * t, 5e-3 + 0.08 * t, -4e-3 - 0.02 * t};
        VBSS_TRY(vbss_drain_set_attachment_target(handle, 1, to));
    }
    if (s.steps == 60) {
        VBSS_TRY(vbss_drain_detach(handle, 1));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_FORCE, p.marks[1]));
    }
    return vbss_drain_step(handle, s.steps % 3 == 0 ? 5e-4 : 1e-3);
}

static vbss_result destroy(void *handle)
{
    return vbss_drain_destroy(handle);
}

static void pulled_tears(const contract_run *run)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *drain = NULL;
    vbss_drain_statistics s;
    expect_ok(run->body.create(context, run->body.user, &drain));
    for (int i = 0; i < 55; i++) {
        expect_ok(run->body.step(drain));
    }
    expect_ok(vbss_drain_get_statistics(drain, &s, sizeof s));
    assert_in_range(s.torn, 2, 32);
    assert_true(s.parts > s.steps);
    harness_context_end(context, &memory);
}

#define PULLED_RUN(title, covered, ...)                                                       \
    {                                                                                         \
        .name = (title), .body = {"drain",     &vbss_drain_kind, pulled_create,         NULL, \
                                  pulled_step, destroy,          &(pulled){__VA_ARGS__}},     \
        .saves = {1, 30, 55, 70}, .save_count = 4, .continued = 10, .damages = {10, 62},      \
        .damage_count = 2, .quiet = 80, .repeated = 80, .covers = (covered)                   \
    }

/* ---- states that no drain can have: pinned at node 0, a force at node 1 */

static vbss_result held_create(vbss_context *context, void *user, void **handle)
{
    vbss_drain_config config;
    vbss_view view;
    vbss_drain_attachment a;
    uint32_t id;
    (void)user;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    VBSS_TRY(vbss_drain_create(context, &config, (vbss_drain **)handle));
    VBSS_TRY(vbss_drain_get_view(*handle, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    vec3_store(a.position, vec3_load(view.data));
    VBSS_TRY(vbss_drain_attach(*handle, &a, &id));
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    a.node = 1;
    return vbss_drain_attach(*handle, &a, &id);
}

static vbss_result call_step(void *handle)
{
    return vbss_drain_step(handle, 1e-3);
}

static void spoil(void *handle, uint32_t which)
{
    drain_object *d = NULL;
    expect_ok(vbss_drain_open(handle, &d));
    const uint32_t anchor = d->mesh.anchors[3];
    switch (which) {
    case 0:
        d->x[anchor].y += 1e-6;
        break;
    case 1:
        d->v[anchor].y = 1e-6;
        break;
    case 2: /* torn, but not counted */
        d->torn[1] = 1;
        break;
    case 3: /* torn twice */
        d->torn[1] = 2;
        d->statistics.torn = 1;
        break;
    case 4: /* pinned twice */
        d->attachments[1].kind = VBSS_DRAIN_ATTACHMENT_PIN;
        d->attachments[1].node = 0;
        break;
    case 5:
        d->attachments[1].node = d->mesh.anchors[0];
        break;
    case 6: /* one id twice */
        d->attachments[1].id = 1;
        break;
    case 7: /* an id that is not given out yet */
        d->attachments[1].id = 3;
        break;
    default:
        d->attachments[1].stiffness = -1.0;
    }
}

/* ---- the published method, pulled by the host */

enum { PAPER_MIDDLE = 36, PAPER_DOUBLE = 84 };

static vbss_result paper_attach(vbss_drain *drain, vbss_drain_attachment_kind kind, uint32_t node,
                                double stiffness)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.position[1] = 8e-3;
    a.stiffness = stiffness;
    return vbss_drain_attach(drain, &a, &id);
}

static void paper_config(void *config)
{
    vbss_drain_config *c = config;
    expect_ok(vbss_drain_config_init(c, sizeof *c));
    c->method = VBSS_METHOD_VBLAST;
    baseline_of(&c->baseline)->drain_damping = 0.05;
    c->drag = 20.0;
    c->gravity[1] = -9.81;
}

static vbss_result paper_attach_all(vbss_drain *drain)
{
    VBSS_TRY(paper_attach(drain, VBSS_DRAIN_ATTACHMENT_PIN, PAPER_MIDDLE + 1, 0.0));
    VBSS_TRY(paper_attach(drain, VBSS_DRAIN_ATTACHMENT_FORCE, PAPER_MIDDLE + 11, 0.0));
    return paper_attach(drain, VBSS_DRAIN_ATTACHMENT_SPRING, PAPER_DOUBLE, 70.0);
}

static vbss_result paper_create(vbss_context *context, void *user, void **handle)
{
    vbss_drain_config config;
    (void)user;
    paper_config(&config);
    VBSS_TRY(vbss_drain_create(context, &config, (vbss_drain **)handle));
    return paper_attach_all(*handle);
}

static vbss_result paper_step(void *handle)
{
    vbss_drain_statistics s;
    VBSS_TRY(vbss_drain_get_statistics(handle, &s, sizeof s));
    double swing = 0.01 * (double)((s.steps * 7) % 11);
    const double pin[3] = {0.1 * swing, 7e-3, 1e-3}, force[3] = {0.0, swing, -2.0 * swing};
    VBSS_TRY(vbss_drain_set_attachment_target(handle, 1, pin));
    VBSS_TRY(vbss_drain_set_attachment_target(handle, 2, force));
    return vbss_drain_step(handle, 1e-3);
}

/* ---- the object */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_drain_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, config, &drain));
    return vbss_drain_destroy(drain);
}

static vbss_result attachment_init(void *attachment, uint32_t struct_size)
{
    return vbss_drain_attachment_init(attachment, struct_size);
}

static vbss_result attach_and_destroy(vbss_context *context, const void *attachment)
{
    vbss_drain_config config;
    vbss_drain *drain;
    uint32_t id;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    VBSS_TRY(vbss_drain_create(context, &config, &drain));
    vbss_result result = vbss_drain_attach(drain, attachment, &id);
    VBSS_TRY(vbss_drain_destroy(drain));
    return result;
}

static const void *good_config(void)
{
    static vbss_drain_config config;
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    return &config;
}

static vbss_result create_from(vbss_context *context, const void *config, void **handle)
{
    return vbss_drain_create(context, config, (vbss_drain **)handle);
}

/* Pinned at both targets. */
static vbss_result create(vbss_context *context, void **handle)
{
    vbss_drain_config config;
    vbss_drain_places places;
    vbss_view view;
    uint32_t id;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    VBSS_TRY(vbss_drain_create(context, &config, (vbss_drain **)handle));
    VBSS_TRY(vbss_drain_get_places(*handle, &places, sizeof places));
    VBSS_TRY(vbss_drain_get_view(*handle, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    for (int k = 0; k < 2; k++) {
        vbss_drain_attachment a;
        VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
        a.node = places.marks[k];
        vec3_store(a.position, vec3_load((const double *)view.data + 3 * (size_t)places.marks[k]));
        VBSS_TRY(vbss_drain_attach(*handle, &a, &id));
    }
    return VBSS_OK;
}

static vbss_result reject(void *handle)
{
    return vbss_drain_step(handle, 1.0);
}

static vbss_result get_hash(void *handle, uint64_t *hash)
{
    return vbss_drain_get_hash(handle, hash);
}

static vbss_result write_places(void *handle, void *out, uint32_t size)
{
    return vbss_drain_get_places(handle, out, size);
}
static vbss_result write_gap(void *handle, void *out, uint32_t size)
{
    return vbss_drain_get_gap(handle, out, size);
}
static vbss_result write_energies(void *handle, void *out, uint32_t size)
{
    return vbss_drain_get_energies(handle, out, size);
}
static vbss_result write_statistics(void *handle, void *out, uint32_t size)
{
    return vbss_drain_get_statistics(handle, out, size);
}
static vbss_result write_view(void *handle, void *out, uint32_t size)
{
    return vbss_drain_get_view(handle, VBSS_DRAIN_VIEW_STRAINS, out, size);
}

/* Nothing given: nothing placed. */
static vbss_result call_set_state(void *d)
{
    return vbss_drain_set_state(d, NULL, NULL, 137);
}
static vbss_result call_attach(void *d)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    return vbss_drain_attach(d, &a, &id);
}
static vbss_result call_move(void *d)
{
    const double zero[3] = {0.0, 0.0, 0.0};
    return vbss_drain_set_attachment_target(d, 1, zero);
}
static vbss_result call_restore(void *d)
{
    uint8_t bytes[64] = {0};
    return vbss_drain_restore(d, bytes, sizeof bytes);
}
static vbss_result call_detach(void *d)
{
    return vbss_drain_detach(d, 1);
}
static vbss_result call_reaction(void *d)
{
    double force[3];
    return vbss_drain_get_reaction(d, 2, force);
}
static vbss_result call_save(void *d)
{
    uint64_t written;
    vbss_result result = vbss_drain_save(d, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *d)
{
    uint64_t hash;
    return vbss_drain_get_hash(d, &hash);
}
static vbss_result call_places(void *d)
{
    vbss_drain_places out;
    return write_places(d, &out, sizeof out);
}
static vbss_result call_gap(void *d)
{
    vbss_drain_gap out;
    return write_gap(d, &out, sizeof out);
}
static vbss_result call_energies(void *d)
{
    vbss_drain_energies out;
    return write_energies(d, &out, sizeof out);
}
static vbss_result call_statistics(void *d)
{
    vbss_drain_statistics out;
    return write_statistics(d, &out, sizeof out);
}
static vbss_result call_view(void *d)
{
    vbss_view out;
    return write_view(d, &out, sizeof out);
}

/* ---- memory */

static vbss_result use(vbss_drain *drain)
{
    VBSS_TRY(call_attach(drain));
    uint64_t need = 0, count = 0;
    (void)vbss_drain_save(drain, NULL, 0, &need);
    uint8_t *bytes = malloc(need);
    assert_non_null(bytes);
    vbss_result result = vbss_drain_save(drain, bytes, need, &count);
    result = result == VBSS_OK ? vbss_drain_restore(drain, bytes, count) : result;
    free(bytes);
    return result == VBSS_OK ? vbss_drain_step(drain, 1e-3) : result;
}

static vbss_result attempt(vbss_context *context, void *user)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, user, &drain));
    vbss_result result = use(drain);
    VBSS_TRY(vbss_drain_destroy(drain));
    return result;
}

static vbss_result attempt_paper(vbss_context *context, void *user)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, user, &drain));
    expect_ok(paper_attach_all(drain));
    expect_ok(paper_step(drain));
    return vbss_drain_destroy(drain);
}

static vbss_drain_config attempted;

static void *plain(void)
{
    expect_ok(vbss_drain_config_init(&attempted, sizeof attempted));
    return &attempted;
}

static void *fine(void)
{
    expect_ok(vbss_drain_config_init(&attempted, sizeof attempted));
    attempted.attachment_capacity = 1;
    attempted.mesh = VBSS_DRAIN_MESH_225;
    return &attempted;
}

static void *paper(void)
{
    paper_config(&attempted);
    return &attempted;
}

static vbss_result cycle(vbss_context *context, uint32_t i)
{
    vbss_drain_config config;
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.mesh = (vbss_drain_mesh)(i % 4);
    VBSS_TRY(vbss_drain_create(context, &config, &drain));
    VBSS_TRY(vbss_drain_step(drain, 1e-3));
    VBSS_TRY(vbss_drain_step(drain, 1e-3));
    return vbss_drain_destroy(drain);
}

/* Up to `surface`, and up to `tear_energy`. */
#define FIRST_SIZE VBSS_SIZE_WITH_SPLIT_POINTERS(vbss_drain_config, 280u)
static const uint32_t config_sizes[] = {FIRST_SIZE, sizeof(vbss_drain_config), 0},
                      attachment_sizes[] = {72, 0};

static const contract_object object = {
    .name = "drain",
    .configs = {{config_sizes, config_init, create_and_destroy},
                {attachment_sizes, attachment_init, attach_and_destroy}},
    .create = create,
    .create_from = create_from,
    .config = good_config,
    .null_config = VBSS_OK,
    .destroy = destroy,
    .reject = reject,
    .hash = get_hash,
    .outputs = {{32, {0}, write_places},
                {96, {32}, write_gap},
                {56, {0}, write_energies},
                {88, {80}, write_statistics},
                {sizeof(vbss_view), {0}, write_view}},
    .calls = {{.call = call_step, .edits = true},
              {.call = call_set_state, .edits = true},
              {.call = call_attach, .edits = true},
              {.call = call_move, .edits = true},
              {.call = call_restore, .edits = true, .result = VBSS_ERROR_CORRUPT},
              {.call = call_detach, .edits = true},
              {.call = call_reaction},
              {.call = call_save},
              {.call = call_hash},
              {.call = call_places},
              {.call = call_gap},
              {.call = call_energies},
              {.call = call_view},
              {.call = call_statistics}},
    .attempts = {{attempt, plain}, {attempt, fine}, {attempt_paper, paper}},
    .cycle = cycle,
    .cycles = 8,
};

/* ---- snapshots */

static void usual_config(void *config)
{
    expect_ok(vbss_drain_config_init(config, sizeof(vbss_drain_config)));
}

/* The same turn. */
static void scale_orientation(void *config)
{
    ((vbss_drain_config *)config)->orientation[0] = 7.0;
}

static vbss_result save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_drain_save(handle, bytes, capacity, written);
}

static vbss_result restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_drain_restore(handle, bytes, count);
}

#define NUMBER(field)                                \
    {                                                \
        offsetof(vbss_drain_config, field), 1, 0.999 \
    }
#define CHOICE(field)                            \
    {                                            \
        offsetof(vbss_drain_config, field), 0, 1 \
    }

/* The fields that the motion depends on. */
static const contract_snapshot snapshot = {
    .name = "drain",
    .kind = &vbss_drain_kind,
    .config = usual_config,
    .config_size = sizeof(vbss_drain_config),
    .create = create_from,
    .destroy = destroy,
    .save = save,
    .restore = restore,
    .fields = {NUMBER(length),
               NUMBER(radius),
               NUMBER(thickness),
               NUMBER(slit_length),
               NUMBER(slit_opening),
               NUMBER(mark_arc),
               NUMBER(young_modulus),
               NUMBER(poisson_ratio),
               NUMBER(density),
               NUMBER(drag),
               NUMBER(gravity[1]),
               NUMBER(position[2]),
               NUMBER(orientation[3]),
               NUMBER(tear_stress),
               NUMBER(move_limit),
               NUMBER(position_tolerance),
               CHOICE(mesh),
               CHOICE(mesh_divisions),
               CHOICE(attachment_capacity),
               CHOICE(iteration_limit),
               CHOICE(halving_limit)},
    .reserve_more = scale_orientation,
    .step = call_step,
};

static const contract_snapshot paper_snapshot = {
    .name = "drain, baseline",
    .kind = &vbss_drain_kind,
    .config = paper_config,
    .config_size = sizeof(vbss_drain_config),
    .create = create_from,
    .destroy = destroy,
    .fields = {{offsetof(vbss_drain_config, method), 0, VBSS_METHOD_IMPLICIT - VBSS_METHOD_VBLAST}},
};

int test_drain(void)
{
    const contract_run runs[] = {
        PULLED_RUN("pulled drain", NULL, 5e4, 1, VBSS_DRAIN_MESH_137),
        PULLED_RUN("torn drain", pulled_tears, 1.5e4, 1, VBSS_DRAIN_MESH_137),
        PULLED_RUN("torn drain, fine mesh", NULL, 1.5e4, 10, VBSS_DRAIN_MESH_159),
        {.name = "held drain",
         .body = {"drain", &vbss_drain_kind, held_create, NULL, call_step, destroy, NULL},
         .spoil = spoil,
         .spoil_count = 9,
         .spoil_at = 2},
        {.name = "pulled drain, baseline",
         .body = {"paper's drain", &vbss_drain_kind, paper_create, NULL, paper_step, destroy, NULL},
         .saves = {1, 37},
         .save_count = 2,
         .continued = 30,
         .damages = {12},
         .damage_count = 1,
         .quiet = 100,
         .repeated = 201},
    };
    return contract_check_runs("contract.drain", runs, sizeof runs / sizeof runs[0]) +
           contract_check_object("contract.drain", &object) +
           contract_check_snapshot("contract.drain", &snapshot) +
           contract_check_snapshot("contract.drain", &paper_snapshot);
}
