/* Sentences of the coach, written for a trainee. Numbers stand beside them, not in them. */
#include "session/session.h"

/* A sentence for each hand, from its parts before and after the hand's name. */
#define EITHER(before, after)                                           \
    {                                                                   \
        before "left" after, before "right" after, before "third" after \
    }
/* The same with the other hand's name at a second place. */
#define BOTH(before, between, after)                                              \
    {                                                                             \
        before "left" between "right" after, before "right" between "left" after, \
            before "third" between "other" after                                  \
    }

enum { WORDS_HANDS = 3 };

static const char *const goals[VBSS_SESSION_GOAL_CUT + 1][WORDS_HANDS] = {
    [VBSS_SESSION_GOAL_NONE] = {"There is nothing to do.", "There is nothing to do.",
                                "There is nothing to do."},
    [VBSS_SESSION_GOAL_TAKE_NEEDLE] =
        EITHER("Take the needle with the ",
               " tool, a little more than halfway from its tip, with the jaws square to it."),
    [VBSS_SESSION_GOAL_REACH_MARK] =
        EITHER("With the ", " tool, bring the needle's tip to the mark and point it straight at "
                            "the wall."),
    [VBSS_SESSION_GOAL_PIERCE] =
        BOTH("With the ", " tool, push the tip straight through the wall at the mark, while the ",
             " tool, closed, supports the wall from inside, beside the mark."),
    [VBSS_SESSION_GOAL_DRIVE] =
        EITHER("Turn the ", " wrist so that the needle follows its own curve to the other mark."),
    [VBSS_SESSION_GOAL_EXPOSE_TIP] =
        EITHER("Turn the needle on with the ", " tool until its tip stands clear of the wall."),
    [VBSS_SESSION_GOAL_TAKE_TIP] =
        EITHER("Take the needle behind its tip with the ", " tool, outside the wall."),
    [VBSS_SESSION_GOAL_RELEASE_NEEDLE] =
        BOTH("Open the ", " tool and let go of the needle; the ", " tool has it."),
    [VBSS_SESSION_GOAL_DRAW_NEEDLE] =
        EITHER("Turn the needle out of the drain with the ", " tool, along its curve."),
    [VBSS_SESSION_GOAL_DRAW_THREAD] =
        EITHER("Draw the thread through slowly with the ", " tool until the tail is short."),
    [VBSS_SESSION_GOAL_LENGTHEN_TAIL] = EITHER(
        "The tail is too short: draw some thread back at the first hole with the ", " tool."),
    [VBSS_SESSION_GOAL_TAKE_TAIL] =
        EITHER("Take the tail close to its end from above with the ",
               " tool, its jaws down and inward, and keep the thread snug: slack turns fall off."),
    [VBSS_SESSION_GOAL_RELEASE_TAIL] =
        EITHER("Give both ends a little slack, then open the ", " tool and let go of the tail."),
    [VBSS_SESSION_GOAL_DRAW_TAIL] = EITHER(
        "Draw the tail through the turns with the ",
        " tool, over the slit to its own side, where its jaws point back, and give way with the "
        "other hand."),
    [VBSS_SESSION_GOAL_SEAT] = EITHER("Pull both ends apart, low and equally hard, the ",
                                      " tool to its own side, until the slit is closed."),
    [VBSS_SESSION_GOAL_HAND_OVER] =
        EITHER("Take the needle over with the ", " tool, before you let go with the other one."),
    [VBSS_SESSION_GOAL_TAKE_SHEARS] = EITHER("Change the ", " tool for shears."),
};

/* By hand that winds, by throw (0: the first), by sense (0: from below, 1: over the top). */
#define WINDING(limb, loop, turns)                                              \
    {                                                                           \
        "With the " limb " tool, wind the thread " turns " round the " loop     \
        " tool's jaws: underneath, away from you, then back over the top.",     \
            "With the " limb " tool, wind the thread " turns " round the " loop \
            " tool's jaws: over the top, away from you, then back underneath."  \
    }
#define WINDINGS(limb, loop)                                                        \
    {                                                                               \
        WINDING(limb, loop, "a good two turns"), WINDING(limb, loop, "a good turn") \
    }
static const char *const windings[2][2][2] = {WINDINGS("left", "right"), WINDINGS("right", "left")};

static const char *const cuts[2] = {
    "Cut the short tail a few millimetres from the knot, with the blades across it.",
    "Hold the needle's thread up and cut it a few millimetres from the knot, with the blades "
    "across it."};

const char *vbss_session_goal_sentence(session_goal goal, uint32_t number, uint32_t wraps,
                                       bool is_over)
{
    if (goal.goal == VBSS_SESSION_GOAL_WIND) {
        return windings[goal.tool == VBSS_METRICS_TOOL_RIGHT][wraps == 1][is_over];
    }
    return goal.goal == VBSS_SESSION_GOAL_CUT ? cuts[number % 2] : goals[goal.goal][goal.tool];
}

/* Before the hands have changed sides, and after. */
static const char *const crossings[2][2] = {
    {"The slit is open. With both ends slack, take the left tool to the right along the near side, "
     "and the right one to the left along the far side; then pull both ends, low and equally hard, "
     "until it is closed.",
     "The slit is open. With both ends slack, take the right tool to the left along the near side, "
     "and the left one to the right along the far side; then pull both ends, low and equally hard, "
     "until it is closed."},
    {"Pull both ends apart, low and equally hard, the left tool to the right, until the slit is "
     "closed.",
     "Pull both ends apart, low and equally hard, the right tool to the left, until the slit is "
     "closed."}};

const char *vbss_session_crossing_sentence(uint32_t loop, bool are_crossed)
{
    return crossings[are_crossed][loop % SESSION_HANDS];
}

const char *vbss_session_building_remedy(void)
{
    return "Go on to the next throw: drawn tight, it closes the slit and holds it.";
}

static const struct {
    const char *sentence, *remedy;
} mistakes[VBSS_SESSION_MISTAKE_COUNT] = {
    [VBSS_SESSION_MISTAKE_NEEDLE_DROPPED] = {"The needle is dropped.", "Take it up again."},
    [VBSS_SESSION_MISTAKE_ENTRY_MISSED] = {"The needle went in beside the mark.",
                                           "Draw it back out and pierce the mark itself; once the "
                                           "thread is through, go on."},
    [VBSS_SESSION_MISTAKE_EXIT_MISSED] = {"The needle came out beside the mark.",
                                          "Turn it back into the drain and aim again; once the "
                                          "thread is through, go on."},
    [VBSS_SESSION_MISTAKE_STRAY_HOLE] = {"The needle is in the wall at a third place.",
                                         "Draw it back out of there."},
    [VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN] = {"The needle came back out of the first wall.",
                                               "Bring the tip to the mark and push it in again."},
    [VBSS_SESSION_MISTAKE_THREAD_PULLED_OUT] = {"The thread was pulled out of the stitch.",
                                                "Make the stitch again from the first mark."},
    [VBSS_SESSION_MISTAKE_TAIL_SHORT] = {"The tail is too short to be taken.",
                                         "Draw some thread back at the first hole."},
    [VBSS_SESSION_MISTAKE_TAIL_LONG] = {"The tail is too long; its end is hard to draw through "
                                        "the turns.",
                                        "Unwind, draw the thread on until the tail is short, and "
                                        "wind again."},
    [VBSS_SESSION_MISTAKE_TOWARD_HANDLE] = {"The turns run toward the handle, and such turns tie "
                                            "nothing.",
                                            "Unwind, and lay each turn nearer to the tip than the "
                                            "one before."},
    [VBSS_SESSION_MISTAKE_WRONG_SENSE] = {"You wind the same way as in the throw before, which "
                                          "ties a granny.",
                                          "Unwind, and wind the other way round."},
    [VBSS_SESSION_MISTAKE_TURNS_LOST] = {"Turns have come off the jaws.",
                                         "Wind them again, and keep the thread snug."},
    [VBSS_SESSION_MISTAKE_TOO_FEW_TURNS] = {"There are too few turns on the jaws for this throw.",
                                            "Let go of the tail and wind on."},
    [VBSS_SESSION_MISTAKE_BIGHT] = {"You hold the tail too far from its end, and would draw a "
                                    "loop through.",
                                    "Let go, and take the tail close to its end."},
    [VBSS_SESSION_MISTAKE_TAIL_DROPPED] = {"The tail is dropped before it was through.",
                                           "Take its end again before the turns come off."},
    [VBSS_SESSION_MISTAKE_THROW_UNDONE] = {"A throw has come undone.", "Tie it again."},
    [VBSS_SESSION_MISTAKE_GRANNY] = {"The throw has the sense of the one before: a granny, which "
                                     "slips.",
                                     "While it is loose, draw the tail back out and wind the other "
                                     "way; once it is tight, go on and alternate."},
    [VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS] = {"The first throw has one wrap and needs two.",
                                            "While it is loose, draw the tail back out and wind a "
                                            "good two turns; once it is tight, go on."},
    [VBSS_SESSION_MISTAKE_TOO_MANY_WRAPS] = {"The throw has more wraps than it needs.",
                                             "While it is loose, draw the tail back out and wind "
                                             "less; once it is tight, go on."},
    [VBSS_SESSION_MISTAKE_STRAY_KNOT] = {"There is a knot in one limb of the thread alone.",
                                         "Open it before you pull, or it jams."},
    [VBSS_SESSION_MISTAKE_CAPSIZED] =
        {"A throw has turned over into a hitch, which slides.",
         "Pulling does not make it flat again. Draw the slit shut with it, and "
         "tie the next throws on top."},
    [VBSS_SESSION_MISTAKE_ONE_SIDED] = {"You pull at one end only, and the throw will turn over.",
                                        "Pull both ends equally hard."},
    [VBSS_SESSION_MISTAKE_SLACK] = {"The throw is tied but hangs loose.",
                                    "Pull both ends apart, low and equally hard."},
    [VBSS_SESSION_MISTAKE_SLIT_OPENED] = {"The slit has opened again under the throw.",
                                          "Pull both ends once more, and keep them tense."},
    [VBSS_SESSION_MISTAKE_WALLS_CROSSED] = {"The walls of the slit have slipped past each other.",
                                            "Pull less hard, until the edges meet again."},
    [VBSS_SESSION_MISTAKE_DRAIN_TEARING] = {"You are tearing the drain off its base.",
                                            "Pull less hard, or it comes off and the task fails."},
    [VBSS_SESSION_MISTAKE_PULLED_HARD] = {"You pull harder than any knot needs.", "Ease off."},
    [VBSS_SESSION_MISTAKE_TRANSFER_MISSED] = {"The needle has not changed hands before this "
                                              "throw.",
                                              "Hand it over before the next one."},
    [VBSS_SESSION_MISTAKE_TIME_UP] = {"The time is up.", "Start the task again."},
    [VBSS_SESSION_MISTAKE_DRAIN_TORN] = {"The drain is torn off.",
                                         "Start the task again, and pull along the drain's top "
                                         "rather than up."},
    [VBSS_SESSION_MISTAKE_CUT_EARLY] = {"The thread was cut before the third throw was seated.",
                                        "Start the task again."},
    [VBSS_SESSION_MISTAKE_CUT_KNOT] = {"The cut went through the knot or the stitch.",
                                       "Start the task again, and cut farther from the knot."},
    [VBSS_SESSION_MISTAKE_THREAD_BROKEN] = {"The thread has broken.",
                                            "Start the task again, and pull less hard."},
};

static bool is_mistake(vbss_session_mistake mistake)
{
    return mistake > VBSS_SESSION_MISTAKE_NONE && mistake < VBSS_SESSION_MISTAKE_COUNT;
}

const char *vbss_session_mistake_string(vbss_session_mistake mistake)
{
    return is_mistake(mistake) ? mistakes[mistake].sentence : "";
}

const char *vbss_session_remedy_string(vbss_session_mistake mistake)
{
    return is_mistake(mistake) ? mistakes[mistake].remedy : "";
}
