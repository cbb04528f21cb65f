/* The scripted surgeon's whole task by controllers, natively: their poses come once a frame, and late, as in a headset.
 *
 *     web_perform SEED FRAME LATE     ms; frames */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "perform.h"

enum { SIDES = 2, WANTED = 10, MAX_LATE = 8, LONGEST = 300000 };

typedef struct poses {
    double of[MAX_LATE][SIDES][WANTED]; /* of the last frames */
    int frames;
    int shears[SIDES];
} poses;

static int lead(poses *p, int late, int frame)
{
    for (int side = 0; side < SIDES; side++) {
        const double *q = p->of[(p->frames + MAX_LATE - late) % MAX_LATE][side];
        memcpy(p->of[p->frames % MAX_LATE][side], page_wanted(side), sizeof p->of[0][0]);
        page_pose(side, q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7], 0, 1e-3 * frame);
        const int wants = q[8] > 0.0;
        if (wants != p->shears[side] && page_exchange(side) != 0) {
            return 1;
        }
        p->shears[side] = wants;
    }
    p->frames++;
    return 0;
}

static int perform(poses *p, int frame, int late)
{
    for (int side = 0; side < SIDES; side++) {
        if (page_track(side, 1) != 0) {
            return 1;
        }
        for (int i = 0; i < MAX_LATE; i++) {
            memcpy(p->of[i][side], page_wanted(side), sizeof p->of[i][side]);
        }
    }
    while (page_wanted(0)[9] == 0.0 && p->frames * frame < LONGEST) {
        if (lead(p, late, frame) != 0 || page_step(frame) != 0) {
            return 1;
        }
    }
    return page_end();
}

int main(int argc, char **argv)
{
    static poses p;
    const int frame = argc == 4 ? atoi(argv[2]) : 0, late = argc == 4 ? atoi(argv[3]) : 0;
    if (frame < 1 || late < 1 || late >= MAX_LATE) {
        fprintf(stderr, "usage: %s SEED FRAME LATE (frames, below %d)\n", argv[0], MAX_LATE);
        return 2;
    }
    if (page_perform((uint32_t)strtoul(argv[1], NULL, 10)) != 0 || perform(&p, frame, late) != 0) {
        fprintf(stderr, "%s\n", page_problem());
        return 1;
    }
    printf("seed %s, %d ms a frame, %d late: %s after %.1f s, session %016" PRIx64 "\n%s\n",
           argv[1], frame, late, page_doing(), 1e-3 * p.frames * frame, page_session_hash(),
           page_state());
    return 0;
}
