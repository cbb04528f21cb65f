/* What a script is told, where a person sees the picture; and lockstep: it makes the window's frames, so that nothing it does is
 * ever too late. Mouse and keys are those of the screen all the same. */
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

#include "playing.h"

enum { PATIENCE = 2 }; /* ms, for a grant */

static void report_devices(const playing *p)
{
    for (int side = 0; side < SIDES; side++) {
        if (live_by_device(&p->live, side)) {
            const grip *g = &p->live.grips[side];
            printf(" device %d status %d stopped %d joined %d out %.5f %u", side, (int)g->in.status,
                   (int)g->in.stopped, g->joined, g->force, (unsigned)g->on);
        }
    }
}

static void report(playing *p)
{
    static const char *const names[SIDES] = {"left", "right"};
    const vec *x = throw_rig_nodes(p->live.stage.rig);
    const uint32_t last = p->live.stage.rig->nodes - 1;
    (void)overlay_judge(&p->show, p->live.time);
    printf("frame %llu time %.3f active %s taken %d motion %.1f %.1f wheel %.1f events %llu "
           "renewed %u",
           (unsigned long long)p->frames, p->live.time, names[p->live.active], p->window.taken,
           p->motion[0], p->motion[1], p->window.wheel, (unsigned long long)p->window.events,
           p->window.renewed);
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        const vbss_device_input *in =
            live_by_device(&p->live, side) ? &p->live.grips[side].in : &p->live.hands[side].in;
        if (vbss_grasper_get_state(p->live.hands[side].tool, &tool, sizeof tool) != VBSS_OK) {
            continue;
        }
        const double *q = tool.orientation, *f = tool.hand_force;
        printf(" %s %.3f %.3f %.3f told %.3f %.3f %.3f turned %.4f %.4f %.4f %.4f jaw %.3f holds "
               "%u needle %u force %.4f",
               names[side], 1e3 * tool.position[0], 1e3 * tool.position[1], 1e3 * tool.position[2],
               1e3 * in->position[0], 1e3 * in->position[1], 1e3 * in->position[2], q[0], q[1],
               q[2], q[3], in->jaw, (unsigned)tool.grasp_count, (unsigned)tool.needle,
               sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    }
    printf(" ends %.3f %.3f %.3f %.3f %.3f %.3f knot %d %u %s", 1e3 * x[0].x, 1e3 * x[0].y,
           1e3 * x[0].z, 1e3 * x[last].x, 1e3 * x[last].y, 1e3 * x[last].z,
           (int)p->show.knot.state.verdict, (unsigned)p->show.knot.state.throw_count,
           p->show.knot.notation[0] != '\0' ? p->show.knot.notation : "-");
    status_print(&p->show, p->live.time);
    if ((p->show.overlays & SHOW_COACH) != 0) {
        coaching_print(&p->show);
    }
    report_devices(p);
    printf(" size %d %d\n", p->show.renderer.lens.width, p->show.renderer.lens.height);
    fflush(stdout);
}

/* ---- lockstep */

/* Grows with everything that comes. */
static uint64_t count_events(const playing *p)
{
    return p->window.events + (uint64_t)p->window.moves;
}

void reporting_frame(playing *p)
{
    p->reported = count_events(p);
    report(p);
}

static void read_grants(playing *p)
{
    char bytes[256];
    struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
    if (poll(&in, 1, PATIENCE) <= 0) {
        return;
    }
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) { /* nobody is there any more */
        window_close(&p->window);
    } else {
        p->granted += (uint64_t)count;
    }
}

bool reporting_grants(playing *p)
{
    if (p->granted == 0) {
        read_grants(p);
    }
    if (p->granted > 0) {
        p->granted--;
        return true;
    }
    if (p->o->report != 0 && count_events(p) != p->reported) {
        reporting_frame(p);
    }
    return false;
}
