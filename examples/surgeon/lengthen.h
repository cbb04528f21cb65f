/* A tail that has become too short: the left hand takes it at the hole and draws it out, while the right hand gives slack. */
#ifndef VBSS_EXAMPLES_SURGEON_LENGTHEN_H
#define VBSS_EXAMPLES_SURGEON_LENGTHEN_H

#include "surgeon/pull.h"
#include "throw/catch.h"

typedef enum lengthen_state {
    LENGTHEN_NOT,   /* not needed so far */
    LENGTHEN_SLACK, /* the right hand gives it */
    LENGTHEN_TAKE,  /* the left hand takes the tail beside the hole */
    LENGTHEN_DRAW,
    LENGTHEN_EASE, /* until the tail no longer draws */
    LENGTHEN_LEAVE,
    LENGTHEN_DONE,
    LENGTHEN_FAILED
} lengthen_state;

typedef struct lengthen_run {
    pull_run *pull;
    senses *see;
    lengthen_state state;
    double since;
    pose needle;    /* where the right hand shall hold it */
    catch_run grip; /* of the left hand */
    vec carrot;     /* where its tip shall go */
    vec away;       /* from the hole */
} lengthen_run;

/* The senses know both holes. */
void lengthen_begin(lengthen_run *l, pull_run *pull, senses *see);
void lengthen_step(lengthen_run *l, double dt);
const char *lengthen_name(lengthen_state state);

#endif
