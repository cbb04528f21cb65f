/* Words for what a detector answers. */
#include "knots/words.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char *const names[] = {
    "no knot",     "single throw",    "double throw",       "triple throw",
    "square knot", "granny knot",     "surgeon's knot",     "surgeon's granny",
    "FLS knot",    "stack of throws", "no stack of throws",
};

static const char *const results[] = {"none",   "wrapping",  "passed",
                                      "formed", "certified", "uncertain"};

typedef struct word {
    uint32_t bit;
    const char *text;
} word;

static const word faults_named[] = {
    {VBSS_KNOT_FAULT_FIRST, "first throw not of two wraps"},
    {VBSS_KNOT_FAULT_LATER, "a later one not of one"},
    {VBSS_KNOT_FAULT_FEW, "too few throws"},
    {VBSS_KNOT_FAULT_MANY, "too many throws"},
    {VBSS_KNOT_FAULT_GRANNY, "same hand twice"},
    {VBSS_KNOT_FAULT_STRAY, "knot in one limb"},
    {VBSS_KNOT_FAULT_HITCH, "half hitch"},
    {VBSS_KNOT_FAULT_ORDER, "order not known"},
    {VBSS_KNOT_FAULT_TYPE, "no stack of throws"},
    {VBSS_KNOT_FAULT_UNCERTAIN, "uncertain"},
};
enum { FAULTS = sizeof faults_named / sizeof faults_named[0] };

static const word flags_named[] = {
    {VBSS_KNOT_THROW_GRANNY, ", granny"},
    {VBSS_KNOT_THROW_STRAY, ", stray"},
    {VBSS_KNOT_THROW_HITCH, ", half hitch"},
    {VBSS_KNOT_THROW_REVOCABLE, ", revocable"},
};
enum { FLAGS = sizeof flags_named / sizeof flags_named[0] };

static void add(char text[WORD_TAGS], const char *more)
{
    size_t used = strlen(text);
    snprintf(text + used, WORD_TAGS - used, "%s", more);
}

const char *words_of_name(vbss_knot_name name)
{
    return name >= 0 && name <= VBSS_KNOT_NAME_OTHER ? names[name] : "?";
}

const char *words_of_result(vbss_knot_verdict result)
{
    return result >= 0 && result <= VBSS_KNOT_VERDICT_UNCERTAIN ? results[result] : "?";
}

void words_of_throw(const vbss_knot_throw *t, char text[WORD_TAGS])
{
    snprintf(text, WORD_TAGS, "%d wrap%s, %s-handed, %s", (int)t->wraps, t->wraps == 1 ? "" : "s",
             t->handedness > 0 ? "right" : "left", words_of_result(t->verdict));
    for (int i = 0; i < FLAGS; i++) {
        add(text, (t->flags & flags_named[i].bit) != 0 ? flags_named[i].text : "");
    }
}

void words_of_faults(uint32_t faults, char text[WORD_TAGS])
{
    snprintf(text, WORD_TAGS, "%s", faults == 0 ? "no faults" : "faults: ");
    bool first = true;
    for (int i = 0; i < FAULTS; i++) {
        if ((faults & faults_named[i].bit) != 0) {
            add(text, first ? "" : "; ");
            add(text, faults_named[i].text);
            first = false;
        }
    }
}
