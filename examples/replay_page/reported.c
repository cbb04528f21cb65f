#include "replay_page/reported.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "knots/words.h"

/* ---- words in JSON in a page: what may end the script, and what is no ASCII, by number */

static void put_word(page *p, const void *text, size_t count)
{
    const uint8_t *bytes = text;
    put(p, "\"");
    for (size_t i = 0; i < count; i++) {
        bool plain = bytes[i] >= ' ' && bytes[i] < 127 && strchr("\"\\<>&", bytes[i]) == NULL;
        if (plain) {
            put_markup(p, (const char *)bytes + i, 1);
        } else {
            put(p, "\\u00%02x", (unsigned)bytes[i]);
        }
    }
    put(p, "\"");
}

static void put_string(page *p, const char *text)
{
    put_word(p, text, strlen(text));
}

/* ---- events */

typedef struct reporting {
    uint32_t kind;
    const char *class, *words; /* %1: the first body, %2: the second */
} reporting;

static const reporting tellings[] = {
    {VBSS_SCENE_EVENT_GRASP, "hold", "%2 takes %1"},
    {VBSS_SCENE_EVENT_RELEASE, "hold", "%2 lets %1 go"},
    {VBSS_SCENE_EVENT_TORN, "bad", "%1 is torn out of %2"},
    {VBSS_SCENE_EVENT_SLIP, "warn", "%1 slips in %2"},
    {VBSS_SCENE_EVENT_CUT, "cut", "%1 is cut"},
    {VBSS_SCENE_EVENT_EXCHANGED, "tool", "%1 is exchanged"},
    {VBSS_SCENE_EVENT_PUNCTURE, "wall", "%1 enters the wall of %2"},
    {VBSS_SCENE_EVENT_WITHDRAWN, "bad", "%1 is drawn back out of the wall of %2"},
    {VBSS_SCENE_EVENT_PASSED, "wall", "%1 is through the wall of %2"},
    {VBSS_SCENE_EVENT_RETURNED, "warn", "%1 is in the wall of %2 again"},
    {VBSS_SCENE_EVENT_UNTHREADED, "warn", "an end of %1 leaves the wall of %2"},
    {VBSS_SCENE_EVENT_TEARING, "bad", "%1 tears the wall of %2"},
    {VBSS_SCENE_EVENT_TORN_OUT, "bad", "%1 has torn out of the wall of %2"},
    {VBSS_SCENE_EVENT_HOLE_LOST, "bad", "no room for a hole of %1 in %2"},
    {VBSS_RECORD_EVENT_TIME_LOST, "step", "a step is cut short or paused"},
    {VBSS_SCENE_EVENT_BLOCKED, "step", "%1 and %2 hold each other back"},
    {VBSS_SCENE_EVENT_UNBLOCKED, "step", "%1 and %2 move freely again"},
};
enum { TELLINGS = sizeof tellings / sizeof tellings[0] };

static const char *name_of(const facts *f, const film *shown, uint32_t body)
{
    static const char *const names[] = {"a body",        "the thread", "the drain", "the needle",
                                        "needle driver", "the shears", "a body",    "the floor"};
    for (int side = 0; side < SIDES; side++) {
        if (f->tools[side] == body && body != 0) {
            return side == LEFT ? "the left tool" : "the right tool";
        }
    }
    for (uint32_t i = 0; i < shown->model_count; i++) {
        if (shown->models[i].body == body && shown->models[i].kind <= VBSS_VISUAL_KIND_FLOOR) {
            return names[shown->models[i].kind];
        }
    }
    return names[0];
}

static void put_reporting(page *p, const facts *f, const film *shown, const reporting *t,
                          const happening *e)
{
    char text[WORD_TAGS] = "";
    size_t used = 0;
    for (const char *c = t->words; *c != '\0' && used + 1 < sizeof text; c++) {
        if (*c == '%') {
            uint32_t body = *++c == '1' ? e->first : e->second;
            int more = snprintf(text + used, sizeof text - used, "%s", name_of(f, shown, body));
            used += more > 0 ? (size_t)more : 0;
        } else {
            text[used++] = *c;
            text[used] = '\0';
        }
    }
    put(p, "{\"time\":%.4f,\"class\":\"%s\",\"words\":", e->time, t->class);
    put_string(p, text);
    put(p, "}");
}

/* Of what happens again within a frame between the same two the first is told. */
static bool is_first_report(const facts *f, size_t i, double apart)
{
    const happening *e = &f->events[i];
    while (i-- > 0 && e->time - f->events[i].time < apart) {
        const happening *b = &f->events[i];
        if (b->kind == e->kind && b->first == e->first && b->second == e->second &&
            e->kind != VBSS_SCENE_EVENT_PUNCTURE && e->kind != VBSS_SCENE_EVENT_PASSED) {
            return false;
        }
    }
    return true;
}

static void put_events(page *p, const facts *f, const film *shown)
{
    const double apart = shown->frames > 1 ? facts_end(f) / (shown->frames - 1) : 0.0;
    bool first = true;
    put(p, "\"events\":[");
    for (size_t i = 0; i < f->event_count; i++) {
        for (int k = 0; k < TELLINGS; k++) {
            if (f->events[i].kind == tellings[k].kind && is_first_report(f, i, apart)) {
                put(p, "%s", first ? "" : ",\n");
                put_reporting(p, f, shown, &tellings[k], &f->events[i]);
                first = false;
            }
        }
    }
    put(p, "]");
}

/* ---- phases and knots */

static void put_phases(page *p, const facts *f)
{
    put(p, "\"phases\":[");
    for (size_t i = 0; i < f->phase_count; i++) {
        put(p, "%s{\"from\":%.4f,\"to\":%.4f,\"name\":", i > 0 ? "," : "", f->phases[i].from,
            f->phases[i].to);
        put_string(p, f->phases[i].name);
        put(p, "}");
    }
    put(p, "]");
}

static void put_knots(page *p, const facts *f)
{
    const again *a = &f->again;
    put(p, "\"knots\":[");
    for (size_t i = 0; i < a->reading_count; i++) {
        const reading *r = &a->readings[i];
        const bool none = r->notation[0] == '\0';
        put(p, "%s{\"time\":%.4f,\"notation\":", i > 0 ? "," : "", r->time);
        put_string(p, r->notation);
        put(p, ",\"name\":");
        put_string(p, none ? "no knot" : words_of_name(r->state.name));
        put(p, ",\"verdict\":");
        put_string(p, none && r->state.verdict != VBSS_KNOT_VERDICT_UNCERTAIN
                          ? ""
                          : words_of_result(r->state.verdict));
        put(p, "}");
    }
    put(p, "]");
}

/* ---- numbers of each frame */

static const again_step *step_of(const facts *f, uint64_t step)
{
    return step > 0 && step <= f->again.count ? &f->again.steps[step - 1] : NULL;
}

static void put_forces(page *p, const facts *f, const film *shown, const uint64_t *steps, int side)
{
    put(p, "[");
    for (uint32_t i = 0; i < shown->frames; i++) {
        const again_step *s = step_of(f, steps[i]);
        put(p, "%s%.2f", i > 0 ? "," : "", s != NULL ? s->force[side] : 0.0);
    }
    put(p, "]");
}

static void put_series(page *p, const facts *f, const film *shown, const uint64_t *steps)
{
    put(p, "\"times\":[");
    for (uint32_t i = 0; i < shown->frames; i++) {
        put(p, "%s%.4f", i > 0 ? "," : "", steps[i] > 0 ? f->moments[steps[i] - 1].time : 0.0);
    }
    put(p, "],\n\"steps\":[");
    for (uint32_t i = 0; i < shown->frames; i++) {
        put(p, "%s%llu", i > 0 ? "," : "", (unsigned long long)steps[i]);
    }
    put(p, "],\n\"forces\":{\"left\":");
    put_forces(p, f, shown, steps, LEFT);
    put(p, ",\n\"right\":");
    put_forces(p, f, shown, steps, RIGHT);
    put(p, "},\n\"gaps\":[");
    for (uint32_t i = 0; f->again.drain && i < shown->frames; i++) {
        const again_step *s = step_of(f, steps[i]);
        put(p, "%s%.2f", i > 0 ? "," : "", s != NULL ? 1e3 * s->gap : -1.0);
    }
    put(p, "]");
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

void reported_put(page *p, const facts *f, const film *shown, const uint64_t *steps)
{
    const again *a = &f->again;
    const char *fault = a->report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS
                            ? "it plays back to other bits from here on than were recorded"
                        : f->check.result == VBSS_ERROR_TRUNCATED ? "the log is cut off"
                        : f->check.result != VBSS_OK              ? "the log is damaged"
                        : a->result != VBSS_OK                    ? "playing it back failed"
                                                                  : "";
    put(p, "{\"log\":");
    put_string(p, file_name(f->path));
    put(p, ",\"note\":");
    put_word(p, f->info.note, f->info.note_bytes);
    put(p, ",\"scene\":");
    put_string(p, a->name != NULL ? a->name : "");
    put(p, ",\"fault\":");
    put_string(p, fault);
    put(p, ",\n");
    put_events(p, f, shown);
    put(p, ",\n");
    put_phases(p, f);
    put(p, ",\n");
    put_knots(p, f);
    put(p, ",\n");
    put_series(p, f, shown, steps);
    put(p, ",\n\"film\":");
    film_put(p, shown);
    put(p, "}\n");
}
