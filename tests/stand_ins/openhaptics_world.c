/* Arms, hands and scheduler of the stand-in for OpenHaptics, and how tests get at them. SI units. */
#include <math.h>
#include <string.h>

#include "stand_ins/openhaptics_world.h"

enum { SUBSTEPS = 20 };

#define HAND              \
    {                     \
        0.1, 50.0, 2.0,   \
        {                 \
            0.0, 0.0, 0.0 \
        }                 \
    }

/* As a program finds it that knows nothing of stand-ins: ticking in real time. */
hd_world world = {.lock = PTHREAD_MUTEX_INITIALIZER,
                  .arms = {{.hand = HAND}, {.hand = HAND}},
                  .threaded = true,
                  .rate = 1000,
                  .current = NOBODY};

/* ---- errors and the referee */

void push(uint32_t code, uint32_t device)
{
    if (world.error_count < ERRORS) {
        world.errors[world.error_count++] = (hd_error){code, -1, device};
    }
}

void refuse(const char *call, const char *why, uint32_t code)
{
    referee_refuse(&world.judge, call, why);
    push(code, world.current);
}

void enter(void)
{
    pthread_mutex_lock(&world.lock);
}

void leave(void)
{
    pthread_mutex_unlock(&world.lock);
}

bool in_servo(void)
{
    return world.in_callback && pthread_equal(world.caller, pthread_self());
}

/* ---- the hand, in steps within a tick */

static void move(arm *a, double h)
{
    const stand_in_hand *hand = &a->hand;
    for (int k = 0; k < SUBSTEPS; k++) {
        for (int i = 0; i < 3; i++) {
            stand_in_arm *s = &a->now;
            double pull = hand->stiffness * (hand->target[i] - s->position[i]);
            double all = s->force[i] + pull - hand->damping * s->velocity[i];
            s->velocity[i] += h / SUBSTEPS * all / hand->mass;
            double way = h / SUBSTEPS * s->velocity[i];
            s->position[i] += way;
            s->work += s->force[i] * way;
        }
    }
    a->now.ticks++;
}

/* ---- the scheduler */

double seconds(const struct timespec *t)
{
    return (double)t->tv_sec + 1e-9 * (double)t->tv_nsec;
}

double clock_of(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return seconds(&t);
}

static void after_callback(uint32_t code, double cpu)
{
    for (uint32_t i = 0; i < STAND_IN_ARMS; i++) {
        arm *a = &world.arms[i];
        if (a->in_frame) {
            refuse("callback", "it returned inside a frame", FRAME_ERROR);
            a->in_frame = false;
        }
        if (a->opened) {
            a->now.cpu_worst = fmax(a->now.cpu_worst, cpu);
            move(a, 1.0 / (double)world.rate);
        }
    }
    if (code > 1) {
        refuse("callback", "it returned neither done nor continue", INVALID_VALUE);
    }
    world.callback_done = code == 0;
    if (world.error_count > 0) {
        referee_refuse(&world.judge, "callback", "it left errors unread");
        world.error_count = 0;
    }
}

void tick_once(void)
{
    enter();
    bool due = world.running && !world.arms[0].faults[STAND_IN_STALLED] && world.callback != NULL &&
               !world.callback_done;
    if (!due) { /* the hands go on */
        for (int i = 0; world.running && i < STAND_IN_ARMS; i++) {
            if (world.arms[i].opened) {
                move(&world.arms[i], 1.0 / (double)world.rate);
            }
        }
        leave();
        return;
    }
    world.tick++;
    world.in_callback = true;
    world.caller = pthread_self();
    clock_gettime(CLOCK_MONOTONIC, &world.began);
    hd_callback callback = world.callback;
    void *user = world.user;
    leave();
    double before = clock_of(CLOCK_THREAD_CPUTIME_ID);
    uint32_t code = callback(user);
    double cpu = clock_of(CLOCK_THREAD_CPUTIME_ID) - before;
    enter();
    world.in_callback = false;
    after_callback(code, cpu);
    leave();
}

void *serve(void *nothing)
{
    struct timespec next;
    clock_gettime(CLOCK_MONOTONIC, &next);
    (void)nothing;
    for (;;) {
        enter();
        bool running = world.running;
        long period = 1000000000L / (long)world.rate;
        leave();
        if (!running) {
            return NULL;
        }
        tick_once();
        next.tv_nsec += period;
        if (next.tv_nsec >= 1000000000L) {
            next.tv_nsec -= 1000000000L;
            next.tv_sec++;
        }
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, NULL);
    }
}

/* ---- behind the scenes */

static void reset(int threaded)
{
    enter();
    memset(&world.judge, 0, sizeof world.judge);
    memset(world.arms, 0, sizeof world.arms);
    for (int i = 0; i < STAND_IN_ARMS; i++) {
        world.arms[i].hand = (stand_in_hand)HAND;
    }
    world.error_count = 0;
    world.callback = NULL;
    world.running = world.in_callback = world.callback_done = false;
    world.threaded = threaded != 0;
    world.rate = 1000;
    world.tick = 0;
    world.current = NOBODY;
    leave();
}

static void tick(int count)
{
    for (int i = 0; i < count; i++) {
        tick_once();
    }
}

static void set_fault(int which, stand_in_hd_fault fault, int on)
{
    enter();
    world.arms[which].faults[fault] = on != 0;
    leave();
}

static void set_hand(int which, const stand_in_hand *hand)
{
    enter();
    world.arms[which].hand = *hand;
    leave();
}

static void place(int which, const double position[3])
{
    enter();
    memcpy(world.arms[which].now.position, position, sizeof world.arms[which].now.position);
    memset(world.arms[which].now.velocity, 0, sizeof world.arms[which].now.velocity);
    leave();
}

static void look(int which, stand_in_arm *now)
{
    enter();
    *now = world.arms[which].now;
    leave();
}

static int illegal(const char **first)
{
    enter();
    for (int i = 0; i < STAND_IN_ARMS; i++) {
        if (world.arms[i].opened) {
            referee_refuse(&world.judge, "end", "an arm was left open");
        }
    }
    if (world.running || world.callback != NULL) {
        referee_refuse(&world.judge, "end", "the scheduler was left running");
    }
    *first = world.judge.first;
    int count = world.judge.count;
    leave();
    return count;
}

const stand_in_hd_table *stand_in_hd(void)
{
    static const stand_in_hd_table table = {reset, tick, set_fault, set_hand, place, look, illegal};
    return &table;
}
