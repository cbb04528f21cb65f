/* A gamepad as a hand: what its sticks, triggers and buttons say. Pure: whoever reads the pad hands its state in. */
#ifndef VBSS_EXAMPLES_VIEWER_PAD_H
#define VBSS_EXAMPLES_VIEWER_PAD_H

#include <stdbool.h>
#include <stdint.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

/* What a press asks for: bits. */
enum { PAD_JAWS = 1, PAD_OTHER = 2, PAD_PAUSE = 4, PAD_HELP = 8 };

typedef struct pad {
    uint32_t
        down; /* of these, in the last state; what is down in the first one does not count until it was up */
    bool known;
} pad;

typedef struct pad_wish {
    double axes
        [6]; /* as vbss_mapping_gamepad has them, but that the last turns about the tool's own axis */
    bool fine;
    uint32_t pressed; /* since the last state */
} pad_wish;

/* NULL: there is no gamepad, which asks for nothing. */
pad_wish pad_read(pad *p, const GLFWgamepadstate *now);

#endif
