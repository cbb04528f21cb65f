/* How throws are tied, and how they are not: short stories of a thread and two tools, by formula, with the truth
 * of every moment.
 *
 * Frame: tissue at z = 0, the thread goes through it along x (or a stack of throws lies there already). The
 * tool W lies above it along x, its handle at +x, its tip at -x; the tool N holds the needle and comes from -x.
 * The tail limb lies at -x. In a story N winds the long limb about W (so many signed turns looking from W's tip to
 * its handle, from the tissue on), W's jaws grasp the tail and draw it back through the loops until its end is
 * clear of them, let go, and both ends are pulled.
 *
 * What that ties: from the handle's side towards the tip, more than k turns and no more than k + 1 tie a throw
 * of k wraps, left-handed when the turns are positive; towards the handle they tie nothing. */
#ifndef VBSS_TESTS_SCENES_WRAP_SCRIPTS_H
#define VBSS_TESTS_SCENES_WRAP_SCRIPTS_H

#include "scenes/throw_stack.h"

enum { SCRIPT_TOOLS = 2, SCRIPT_N = 0, SCRIPT_W = 1 };

typedef enum script_held {
    SCRIPT_HELD_NOTHING,
    SCRIPT_HELD_THREAD,
    SCRIPT_HELD_NEEDLE
} script_held;

typedef struct script_tool {
    uint32_t points;
    vec3 axis[3]; /* handle to tip */
    double radius[2];
    script_held held;
    double held_place;
} script_tool;

typedef enum script_stage {
    SCRIPT_NOTHING,  /* no throw is being tied, or it would tie nothing */
    SCRIPT_WRAPPING, /* the limb winds about W: |turns| says how far */
    SCRIPT_PASSED, /* the tail is in the jaws, its end not through: tied if they withdraw with it */
    SCRIPT_FORMED, /* the tail's end is through */
    SCRIPT_OPEN    /* an end that nothing holds lies in the loops: no truth */
} script_stage;

typedef struct script_frame {
    thread_line line;
    script_tool tools[SCRIPT_TOOLS];
    script_stage stage;
    double turns;    /* about W, of what is beside it now */
    int sense;       /* of what is wound: +1 towards the tip */
    int wraps, sign; /* of the throw that is passed or formed; 0: none */
    uint32_t throws; /* that are tied, the formed one among them, from the tissue outward */
    int throw_wraps[STACK_THROWS], throw_signs[STACK_THROWS];
    int slip; /* of the formed throw: -1 the long limb lies round a straight tail, 0 flat, +1 */
} script_frame;

typedef struct wrap_script {
    const char *name;
    uint32_t variants; /* handedness, turns, ... */
    bool
        ties; /* whether it should end well: a throw is added in every variant, of the other hand */
} wrap_script;

enum { WRAP_SCRIPTS = 15 };
extern const wrap_script wrap_scripts[WRAP_SCRIPTS];

/* The moment t from 0 to 1; false when so few segments cannot show it (or it makes no sense). 240 do. */
bool wrap_script_frame(uint32_t script, uint32_t variant, double t, uint32_t segments,
                       script_frame *frame);

#endif
