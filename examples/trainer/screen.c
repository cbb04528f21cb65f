#include "trainer/screen.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define FULL_FORCE 3.0 /* N, of the bar */

enum { BAR = 24, BINS_BAR = 30, SHOWN_EVENTS = 4 };

static const char *const side_names[HANDS] = {"left", "right"};

void screen_begin(screen *s)
{
    memset(s, 0, sizeof *s);
    s->terminal = isatty(STDOUT_FILENO) == 1;
    if (s->terminal) {
        fputs("\033[2J\033[?25l", stdout); /* clear, no cursor */
    }
}

void screen_end(const screen *s)
{
    if (s->terminal) {
        fputs("\033[?25h\n", stdout);
    }
}

/* ---- pieces */

static const char *bar(double share, int length, char text[64])
{
    int full = share > 1.0 ? length : share > 0.0 ? (int)(share * length + 0.5) : 0;
    memset(text, '#', (size_t)full);
    memset(text + full, '.', (size_t)(length - full));
    text[length] = '\0';
    return text;
}

static const char *state_of(const hand_figures *h)
{
    static const char *const names[] = {"waiting", "ready", "stale", "lost"};
    return h->in.stopped != 0                                       ? "STOPPED"
           : h->in.clutched != 0                                    ? "clutch"
           : h->in.status == VBSS_DEVICE_STATUS_READY && !h->joined ? "joining"
                                                                    : names[h->in.status];
}

static void show_hand(const task *t, const figures *f, int side)
{
    const hand_figures *h = &f->hands[side];
    char force[64], jaw[64];
    printf(" %-5s  %-8s %s\033[K\n", side_names[side], state_of(h), t->hardware.names[side]);
    printf("    at (%7.2f %7.2f %7.2f) mm\033[K\n", 1e3 * h->in.position[0],
           1e3 * h->in.position[1], 1e3 * h->in.position[2]);
    printf("    force  [%s] %5.2f N, most %5.2f N\033[K\n", bar(h->force / FULL_FORCE, BAR, force),
           h->force, h->max_force);
    printf("    handle [%s] %3.0f %% open   solenoid %s, %" PRIu64 " pulses\033[K\n",
           bar(h->jaw, BAR, jaw), 100.0 * h->jaw, h->solenoid != 0 ? "ON " : "off", h->given);
}

static void show_histogram(const figures *f)
{
    char work[64], late[64];
    uint64_t all = f->slots > 0 ? f->slots : 1;
    printf("      us   %-38s   %s\033[K\n", "work of a slot", "wake-up late by");
    for (int i = 0; i < BINS; i++) {
        bool last = i == BINS - 1;
        printf("  %s%5d   [%s] %7" PRIu64 "   [%s] %7" PRIu64 "\033[K\n", last ? ">=" : " <",
               figures_bins[last ? i - 1 : i],
               bar((double)f->work[i] / (double)all, BINS_BAR - 2, work), f->work[i],
               bar((double)f->late[i] / (double)all, BINS_BAR - 10, late), f->late[i]);
    }
}

static void show_events(const figures *f)
{
    uint32_t first = f->event_count > SHOWN_EVENTS ? f->event_count - SHOWN_EVENTS : 0;
    for (uint32_t i = first; i < f->event_count; i++) {
        printf(" %8.3f s  %.100s\033[K\n", f->events[i].time, f->events[i].text);
    }
}

static void draw(const screen *s, const task *t, const figures *f, const char *system)
{
    fputs("\033[H", stdout);
    printf(" vblast_ss trainer   scene %s   %s%s   %.1f s   Ctrl-C ends\033[K\n",
           t->stage.row->name, f->phase[0] != '\0' ? "phase: " : "", f->phase, f->time);
    printf(" %s\033[K\n\033[K\n", system);
    printf(" rate %7.1f Hz   slots %" PRIu64 "   wall misses %" PRIu64
           "   deadline misses caused by us %" PRIu64 "\033[K\n\033[K\n",
           s->rate, f->slots, f->wall_misses, f->our_misses);
    show_hand(t, f, LEFT);
    show_hand(t, f, RIGHT);
    fputs("\033[K\n", stdout);
    show_histogram(f);
    fputs("\033[K\n", stdout);
    show_events(f);
    fputs("\033[J", stdout);
}

void screen_show(screen *s, const task *t, const figures *f, const char *system)
{
    double passed = f->wall - s->before;
    if (passed >= 0.5 || s->rate == 0.0) {
        s->rate = passed > 0.0 ? (double)(f->slots - s->slots) / passed : 0.0;
        s->before = f->wall;
        s->slots = f->slots;
    }
    if (s->terminal) {
        draw(s, t, f, system);
    } else {
        printf("%9.3f s  %7.1f Hz  wall misses %" PRIu64 "  ours %" PRIu64
               "  force %.2f %.2f N  %s\n",
               f->time, s->rate, f->wall_misses, f->our_misses, f->hands[LEFT].force,
               f->hands[RIGHT].force, f->phase);
    }
    fflush(stdout);
}

/* ---- the report */

static void report_times(const figures *f, bool simulated)
{
    double n = f->slots > 0 ? (double)f->slots : 1.0;
    printf("slots: %" PRIu64 ", deadline misses caused by us: %" PRIu64
           ", work mean %.0f us, most %.0f us\n",
           f->slots, f->our_misses, 1e6 * f->total_work / n, 1e6 * f->worst_work);
    if (!simulated) {
        printf("wall misses: %" PRIu64 ", rate %.1f Hz, latest wake-up %.0f us\n", f->wall_misses,
               f->wall > 0.0 ? (double)f->slots / f->wall : 0.0, 1e6 * f->worst_late);
    }
    fputs("work, us:", stdout);
    for (int i = 0; i < BINS; i++) {
        bool last = i == BINS - 1;
        printf(" %s%d: %" PRIu64, last ? ">=" : "<", figures_bins[last ? i - 1 : i], f->work[i]);
    }
    fputc('\n', stdout);
}

static void report_hand(const task *t, const figures *f, int side)
{
    const hand_figures *h = &f->hands[side];
    printf("%s: %s, old poses %" PRIu64 ", refused %" PRIu64
           ", most force %.2f N, solenoid wanted %" PRIu64 ", let through %" PRIu64,
           side_names[side], t->hardware.names[side], h->old, h->refused, h->max_force, h->asked,
           h->given);
    if (t->rehearsal.daq != NULL && t->hardware.handle[side]) {
        printf(", on the line %" PRIu64, f->pulses[side]);
    }
    if (t->rehearsal.daq != NULL && t->hardware.handle[side] &&
        t->hardware.followers[side].score == NULL) {
        uint64_t script = side == RIGHT ? stage_closings(t->stage.row, f->time) : 0;
        printf(", script %" PRIu64, script);
    }
    fputc('\n', stdout);
}

/* True: every fault that was caused ended in time. */
static bool report_faults(const task *t, const figures *f)
{
    bool good = true;
    for (uint32_t i = 0; i < t->options->fault_count; i++) {
        const fault_finding *found = &f->findings[i];
        const char *name = t->options->faults[i].name;
        if (!found->begun) {
            printf("fault %s: did not come to it\n", name);
        } else if (found->unsafe) {
            printf("fault %s: NOT SAFE after 10 ms\n", name);
        } else {
            printf("fault %s: safe after %.0f ms%s\n", name, 1e3 * found->safe_after,
                   found->acted ? "" : " (nothing was put out before)");
        }
        good = good && !found->unsafe;
    }
    return good;
}

bool screen_report(const task *t, const char *system)
{
    const figures *f = &t->now;
    const char *first;
    printf("scene %s, %.3f s, %s\n", t->stage.row->name, f->time, system);
    if (t->limits[0] != '\0') {
        printf("%s\n", t->limits);
    }
    report_times(f, t->options->simulated);
    report_hand(t, f, LEFT);
    report_hand(t, f, RIGHT);
    for (uint32_t i = 0; i < f->event_count; i++) {
        printf("%.3f s  %s\n", f->events[i].time, f->events[i].text);
    }
    if (f->events_lost > 0) {
        printf("and %" PRIu32 " more\n", f->events_lost);
    }
    stage_report(&t->stage);
    bool good = report_faults(t, f);
    int illegal = rehearsal_illegal(&t->rehearsal, &first);
    if (t->rehearsal.hd != NULL || t->rehearsal.daq != NULL) {
        printf("illegal calls: %d%s%s\n", illegal, illegal > 0 ? ", first " : "", first);
    }
    printf("%s\n", f->faults > 0 ? "ended with faults, outputs off" : "ended well, outputs off");
    return good && illegal == 0 && f->faults == 0;
}
