/* Arms, hands and scheduler of the stand-in for OpenHaptics, and how tests get at them. SI units. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "device/platform.h"
#include "stand_ins/openhaptics_world.h"

enum { SUBSTEPS = 20 };

/* Turned by a little about z, so that rows and columns of the transform differ: by the angle of cosine 0.8. */
#define ARM(stuck)                                                                             \
    {                                                                                          \
        .hand = {.mass = 0.1, .stiffness = 50.0, .damping = 2.0}, .buttons = (stuck), .now = { \
            .turn = {0.9486832980505138, 0.0, 0.0, 0.31622776601683794}                        \
        }                                                                                      \
    }

/* As a program finds it that knows nothing of stand-ins: ticking in real time. */
hd_world world = {.lock = PTHREAD_MUTEX_INITIALIZER,
                  .arms = {ARM(1), ARM(2)},
                  .threaded = true,
                  .rate = 1000,
                  .current = NO_DEVICE};

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

/* Of quaternions. */
static void product(const double a[4], const double b[4], double out[4])
{
    out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[1 + i] = a[0] * b[1 + i] + b[0] * a[1 + i] + a[1 + j] * b[1 + k] - a[1 + k] * b[1 + j];
    }
}

/* The whole of a step at once, as nothing but the hand turns it: on by the share of the angle that e^(-h / wrist) leaves. */
static void turn(arm *a, double h)
{
    const double *to = a->hand.turn;
    double *q = a->now.turn, *spin = a->now.spin, left[4], on[4];
    memset(spin, 0, sizeof a->now.spin);
    if (to[0] == 0.0 && to[1] == 0.0 && to[2] == 0.0 && to[3] == 0.0) {
        return;
    }
    /* left = to q^-1, the shorter way round */
    const double back[4] = {q[0], -q[1], -q[2], -q[3]};
    product(to, back, left);
    const double side = left[0] < 0.0 ? -1.0 : 1.0;
    const double sine = sqrt(left[1] * left[1] + left[2] * left[2] + left[3] * left[3]);
    const double angle = 2.0 * atan2(sine, side * left[0]);
    const double share = a->hand.wrist > 0.0 ? 1.0 - exp(-h / a->hand.wrist) : 1.0;
    if (sine == 0.0) {
        return;
    }
    on[0] = cos(0.5 * share * angle);
    for (int i = 0; i < 3; i++) {
        const double axis = side * left[1 + i] / sine;
        on[1 + i] = sin(0.5 * share * angle) * axis;
        spin[i] = share * angle / h * axis;
    }
    product(on, (const double[4]){q[0], q[1], q[2], q[3]}, q);
    const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++) {
        q[i] /= length; /* of millions of products */
    }
}

static void move(arm *a, double h)
{
    const stand_in_hand *hand = &a->hand;
    turn(a, h);
    for (int k = 0; k < SUBSTEPS; k++) {
        for (int i = 0; i < 3; i++) {
            stand_in_arm *s = &a->now;
            double pull = hand->stiffness * (hand->target[i] - s->position[i]);
            double all = s->force[i] + pull - hand->damping * s->velocity[i];
            s->velocity[i] += h / SUBSTEPS * all / hand->mass;
            double displacement = h / SUBSTEPS * s->velocity[i];
            s->position[i] += displacement;
            s->work += s->force[i] * displacement;
        }
    }
    a->now.ticks++;
}

/* ---- the scheduler */

/* Of the calling thread, s. */
static double cpu_time(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void after_callback(uint32_t code, double cpu)
{
    for (uint32_t i = 0; i < STAND_IN_ARMS; i++) {
        arm *a = &world.arms[i];
        if (a->in_frame) {
            refuse("callback", "it returned inside a frame", FRAME_ERROR);
            a->in_frame = false;
        }
        if (a->is_open) {
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
            if (world.arms[i].is_open) {
                move(&world.arms[i], 1.0 / (double)world.rate);
            }
        }
        leave();
        return;
    }
    world.tick++;
    world.in_callback = true;
    world.caller = pthread_self();
    world.began = vbss_device_time();
    hd_callback callback = world.callback;
    void *user = world.user;
    leave();
    double before = cpu_time();
    uint32_t code = callback(user);
    double cpu = cpu_time() - before;
    enter();
    world.in_callback = false;
    after_callback(code, cpu);
    leave();
}

void *serve(void *nothing)
{
    double next = vbss_device_time();
    (void)nothing;
    for (;;) {
        enter();
        bool running = world.running;
        double period = 1.0 / (double)world.rate;
        leave();
        if (!running) {
            return NULL;
        }
        tick_once();
        next += period;
        vbss_device_sleep(fmax(next - vbss_device_time(), 0.0));
    }
}

/* ---- behind the scenes */

static void reset(int threaded)
{
    enter();
    memset(&world.judge, 0, sizeof world.judge);
    const arm arms[STAND_IN_ARMS] = {ARM(1), ARM(2)};
    memcpy(world.arms, arms, sizeof arms);
    world.error_count = 0;
    world.callback = NULL;
    world.running = world.in_callback = world.callback_done = false;
    world.threaded = threaded != 0;
    world.rate = 1000;
    world.tick = 0;
    world.current = NO_DEVICE;
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

static void place(int which, const double position[3], const double *turned)
{
    enter();
    stand_in_arm *now = &world.arms[which].now;
    memcpy(now->position, position, sizeof now->position);
    memset(now->velocity, 0, sizeof now->velocity);
    if (turned != NULL) {
        memcpy(now->turn, turned, sizeof now->turn);
    }
    leave();
}

static void press(int which, int buttons)
{
    enter();
    world.arms[which].buttons = buttons;
    leave();
}

static void get_state(int which, stand_in_arm *now)
{
    enter();
    *now = world.arms[which].now;
    leave();
}

static int illegal(const char **first)
{
    enter();
    for (int i = 0; i < STAND_IN_ARMS; i++) {
        if (world.arms[i].is_open) {
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
    static const stand_in_hd_table table = {reset, tick,  set_fault, set_hand,
                                            place, press, get_state, illegal};
    return &table;
}
