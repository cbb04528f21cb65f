#include "fixture.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/little_endian.h"
#include "record/step_codec.h"
#include "fixtures/scene_build.h"

enum { NODES = 31 };

stage_options stage_defaults(void)
{
    const stage_options options = {
        0.3, 0.15, 1e-8, 256, VBSS_METHOD_IMPLICIT, VBSS_SCENE_MODE_REAL_TIME, 20.0};
    return options;
}

/* ---- the scene */

static vbss_result add_capsule(stage *s, const stage_options *options, vbss_scene_rigid_kind kind,
                               vec3 at, double half_length, uint32_t *body)
{
    vbss_scene_rigid_config config;
    const vbss_scene_capsule capsule = {{0.0, 0.0, -half_length}, {0.0, 0.0, half_length}, 2e-3};
    VBSS_TRY(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = options->method == VBSS_METHOD_VBLAST ? VBSS_SCENE_RIGID_DRIVEN : kind;
    config.friction = options->tool_friction;
    vec3_store(config.position, at);
    return scene_build_capsule(s->scene, &config, capsule, body);
}

static vbss_result make_thread(stage *s, const stage_options *options)
{
    vbss_thread_config config;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.method = options->method;
    config.segment_count = NODES - 1;
    config.length = 0.09;
    config.bending_stiffness = options->bending_stiffness;
    config.start[1] = 0.03;
    config.damping = 20.0;
    return vbss_thread_create(s->context, &config, &s->thread);
}

vbss_result stage_make(stage *s, const stage_options *options)
{
    vbss_scene_config config;
    uint32_t pin;
    VBSS_TRY(make_thread(s, options));
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.method = options->method;
    config.mode = options->mode;
    config.thread_friction = options->thread_friction;
    config.contact_capacity = options->contact_capacity;
    config.candidate_capacity = 1024;
    config.node_capacity = NODES;
    config.floor = 1;
    config.speed_limit = options->speed_limit;
    VBSS_TRY(vbss_scene_create(s->context, &config, &s->scene));
    VBSS_TRY(vbss_scene_add_thread(s->scene, s->thread, &s->body));
    const vec3 at[3] = {{0.093, 0.03, 0.0}, {0.04, 0.02, 0.0}, {0.06, 0.0021, 0.02}};
    VBSS_TRY(add_capsule(s, options, VBSS_SCENE_RIGID_DRIVEN, at[0], 0.0, &s->tools[0]));
    VBSS_TRY(add_capsule(s, options, VBSS_SCENE_RIGID_DRIVEN, at[1], 0.02, &s->tools[1]));
    VBSS_TRY(add_capsule(s, options, VBSS_SCENE_RIGID_COUPLED, at[2], 0.0, &s->ball));
    VBSS_TRY(vbss_scene_pin_thread(s->scene, s->body, 0, 0, NULL, &pin));
    return vbss_scene_pin_thread(s->scene, s->body, NODES - 1, s->tools[0], NULL, &pin);
}

vbss_result stage_leave(stage *s)
{
    VBSS_TRY(vbss_scene_destroy(s->scene));
    return vbss_thread_destroy(s->thread);
}

void stage_begin(stage *s, const stage_options *options)
{
    const stage_options defaults = stage_defaults();
    memset(s, 0, sizeof *s);
    s->context = harness_context(&s->memory);
    expect_ok(stage_make(s, options != NULL ? options : &defaults));
}

void stage_end(stage *s)
{
    harness_context_end(s->context, &s->memory);
}

/* ---- edits */

static void move_rigid(stage *s, uint32_t body, vec3 at, const double *turned)
{
    double position[3];
    vec3_store(position, at);
    expect_ok(vbss_scene_set_rigid_target(s->scene, body, position, turned));
}

static void attach(stage *s, vbss_thread_attachment_kind kind, uint32_t node, uint32_t *id)
{
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.position[0] = 0.045;
    a.position[1] = 0.035;
    a.direction[1] = 0.1;
    a.force[2] = 1e-3;
    a.stiffness = 2.0;
    a.damping = 1e-3;
    a.mass = 1e-5;
    expect_ok(vbss_thread_attach(s->thread, &a, id));
}

static void move(stage *s, uint32_t id, vec3 to, const double *direction)
{
    double target[3];
    vec3_store(target, to);
    expect_ok(vbss_thread_set_attachment_target(s->thread, id, target, direction));
}

/* A node to the ball, a tenth of a millimetre beside where it is. */
static void pin(stage *s, uint32_t node)
{
    vbss_scene_rigid_state ball;
    vbss_view view;
    double x[3], point[3];
    expect_ok(vbss_scene_get_rigid(s->scene, s->ball, &ball, sizeof ball));
    expect_ok(vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    memcpy(x, (const char *)view.data + (size_t)node * view.stride_bytes, sizeof x);
    const double *q = ball.orientation;
    pose at = pose_make(vec3_load(ball.position), quat_make(q[0], q[1], q[2], q[3]));
    vec3_store(point, vec3_add(pose_apply_inverse(at, vec3_load(x)), vec3_make(0.0, 1e-4, 0.0)));
    expect_ok(vbss_scene_pin_thread(s->scene, s->body, node, s->ball, point, &s->pin));
}

/* In a round of 40 steps every kind of edit is made. */
void stage_report(stage *s, vbss_record *record)
{
    double t = 1e-3 * s->step;
    const double turned[4] = {1.0, 0.0, 0.2 * vbss_sin(40.0 * t), 0.0};
    const double direction[3] = {1.0, vbss_sin(30.0 * t), 0.0};
    uint32_t phase = s->step % 40;
    if (record != NULL) {
        expect_ok(vbss_scene_set_recorder(s->scene, record));
    }
    vec3 sway = vec3_make(-0.01 * (1.0 - vbss_cos(20.0 * t)), 0.004 * vbss_sin(25.0 * t), 0.0);
    move_rigid(s, s->tools[0], vec3_add(vec3_make(0.093, 0.03, 0.0), sway), NULL);
    move_rigid(s, s->tools[1], vec3_make(0.04, 0.02 + 0.014 * vbss_sin(15.0 * t), 0.0), turned);
    if (phase % 4 == 1) {
        move_rigid(s, s->ball, vec3_make(0.06 + 0.01 * t, 0.001, 0.02), NULL);
    }
    if (phase == 3) {
        attach(s, VBSS_THREAD_ATTACHMENT_FORCE, 10, &s->force);
    } else if (phase > 3 && phase < 20) {
        move(s, s->force, vec3_make(0.0, 0.0, 2e-3 * vbss_sin(100.0 * t)), NULL);
    } else if (phase == 20) {
        expect_ok(vbss_thread_detach(s->thread, s->force));
        attach(s, VBSS_THREAD_ATTACHMENT_CLAMP, 22, &s->clamp);
    } else if (phase > 20 && phase < 30) {
        move(s, s->clamp, vec3_make(0.06, 0.035, 0.002), direction);
    } else if (phase == 30) {
        expect_ok(vbss_thread_detach(s->thread, s->clamp));
        pin(s, 26);
    } else if (phase == 37) {
        expect_ok(vbss_scene_unpin_thread(s->scene, s->pin));
    }
}

void stage_step(stage *s, vbss_record *record)
{
    stage_report(s, record);
    expect_ok(vbss_scene_step(s->scene, 1e-3));
    s->step++;
}

uint64_t stage_hash(stage *s)
{
    uint64_t hash;
    expect_ok(vbss_scene_get_hash(s->scene, &hash));
    return hash;
}

vbss_result empty_scene(vbss_context *context, vbss_scene **scene)
{
    vbss_scene_config config;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.thread_capacity = config.rigid_capacity = 1;
    config.node_capacity = config.capsule_capacity = config.pin_capacity = 2;
    config.contact_capacity = config.candidate_capacity = config.event_capacity = 16;
    config.speed_limit = 0.0; /* as in logs of format 2 */
    return vbss_scene_create(context, &config, scene);
}

/* ---- logs */

void log_take(log_bytes *log, vbss_record *record)
{
    const uint8_t *bytes;
    uint64_t count;
    expect_ok(vbss_record_take(record, &bytes, &count));
    log->bytes = realloc(log->bytes, log->count + (size_t)count + 1);
    assert_non_null(log->bytes);
    memcpy(log->bytes + log->count, bytes, (size_t)count);
    log->count += (size_t)count;
}

log_bytes log_of(stage *s, const vbss_record_config *config, uint32_t steps)
{
    log_bytes log = {NULL, 0};
    vbss_record *record;
    expect_ok(vbss_record_create(s->scene, config, &record));
    for (uint32_t i = 0; i < steps; i++) {
        stage_step(s, record);
        if (i % 7 == 3) {
            log_take(&log, record);
        }
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    expect_ok(vbss_record_destroy(record));
    return log;
}

log_bytes log_copy(const log_bytes *log)
{
    log_bytes copy = {malloc(log->count + 1), log->count};
    assert_non_null(copy.bytes);
    memcpy(copy.bytes, log->bytes, log->count);
    return copy;
}

void log_free(log_bytes *log)
{
    free(log->bytes);
    *log = (log_bytes){NULL, 0};
}

bool log_next_place(const log_bytes *log, log_place *place)
{
    place->at = place->next == 0 ? 8 : place->next;
    if (place->at == log->count) {
        return false;
    }
    const uint8_t *record = log->bytes + place->at;
    place->coded = (record[3] & 0xc0u) == 0xc0u;
    place->next = place->at + (place->coded ? 12 + (size_t)load_little_endian(record, 2)
                                            : 16 + (size_t)load_little_endian(record, 4));
    assert_true(place->next <= log->count);
    place->code =
        place->coded ? VBSS_CODE('S', 'T', 'E', 'P') : (uint32_t)load_little_endian(record + 12, 4);
    return true;
}

log_place log_find(const log_bytes *log, uint32_t code, uint32_t n)
{
    log_place place = {.next = 0};
    while (n > 0) {
        assert_true(log_next_place(log, &place));
        n -= place.code == code;
    }
    return place;
}

void log_seal(log_bytes *log)
{
    log_place place = {.next = 0};
    uint8_t before[8];
    memcpy(before, log->bytes, 8);
    while (log_next_place(log, &place)) {
        vbss_hash hash;
        vbss_hash_begin(&hash);
        vbss_hash_add(&hash, before, 8);
        vbss_hash_add(&hash, log->bytes + place.at, place.next - 8 - place.at);
        store_little_endian(before, vbss_hash_end(&hash), 8);
        memcpy(log->bytes + place.next - 8, before, 8);
    }
}

static void append_section(log_bytes *log, const uint8_t *section, size_t count)
{
    log->bytes = realloc(log->bytes, log->count + count + 16);
    assert_non_null(log->bytes);
    store_little_endian(log->bytes + log->count, count, 4);
    store_little_endian(log->bytes + log->count + 4, ~(uint64_t)count, 4);
    memcpy(log->bytes + log->count + 8, section, count);
    log->count += count + 16;
}

static void append_plain_snapshot(vbss_context *context, log_bytes *log, const uint8_t *section,
                                  size_t count)
{
    log_snapshot snapshot = {.number = 0};
    log_snapshot_data raw;
    vbss_stream stream;
    vbss_stream_begin_read(&stream, section, count);
    vbss_log_visit_snapshot(&stream, &snapshot);
    expect_ok(stream.result);
    expect_ok(vbss_log_decompress_snapshot(context, &snapshot, &raw));
    const size_t room = (size_t)snapshot.count + 1024;
    uint8_t *plain = malloc(room);
    assert_non_null(plain);
    snapshot.compressed_bytes = 0;
    vbss_stream_begin_write(&stream, plain, room);
    vbss_log_visit_snapshot(&stream, &snapshot);
    expect_ok(stream.result);
    memcpy(snapshot.destination, raw.bytes, raw.count);
    append_section(log, plain, stream.position);
    free(plain);
    vbss_log_release_snapshot(context, &raw);
}

void log_to_format_2(log_bytes *log)
{
    enum { INPUTS = 1024, SECTION_BYTES = 1 << 16 };
    static uint8_t section[SECTION_BYTES];
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    log_coder *coder;
    log_step step = {.input_capacity = INPUTS};
    log_bytes old = {malloc(8), 8};
    log_place place = {.next = 0};
    uint64_t steps = 0;
    assert_non_null(old.bytes);
    store_little_endian(old.bytes, (uint64_t)2 << 32 | VBSS_CODE('V', 'B', 'S', 'L'), 8);
    expect_ok(vbss_log_allocate_inputs(context, &step));
    expect_ok(vbss_log_allocate_events(context, &step, INPUTS));
    expect_ok(vbss_log_make_coder(context, INPUTS, &coder));
    while (log_next_place(log, &place)) {
        const uint8_t *payload = log->bytes + place.at + (place.coded ? 4 : 8);
        size_t count = place.next - 8 - (size_t)(payload - log->bytes);
        if (place.coded) {
            vbss_stream stream;
            assert_null(vbss_log_decode(coder, steps++, payload, count, &step));
            vbss_stream_begin_write(&stream, section, sizeof section);
            vbss_log_visit_step(&stream, &step);
            expect_ok(stream.result);
            append_section(&old, section, stream.position);
        } else if (place.code == VBSS_CODE('S', 'N', 'A', 'P')) {
            append_plain_snapshot(context, &old, payload, count);
        } else {
            append_section(&old, payload, count);
        }
    }
    vbss_log_free_coder(context, coder);
    vbss_log_free_events(context, &step);
    vbss_log_free_inputs(context, &step);
    harness_context_end(context, &memory);
    log_free(log);
    *log = old;
    log_seal(log);
}

/* ---- replays */

vbss_replay *replay_of(stage *s, const log_bytes *log)
{
    vbss_replay *replay;
    expect_ok(vbss_replay_create(s->context, log->bytes, log->count, &replay));
    return replay;
}

vbss_result replay_all(vbss_replay *replay, vbss_replay_report *report)
{
    vbss_result result;
    do {
        result = vbss_replay_step(replay, report, sizeof *report);
    } while (report->outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    return result;
}

const char *last_text(vbss_context *context)
{
    const char *text;
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    return text;
}
