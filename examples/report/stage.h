/* The scene of a log, made once more. Which one it is, is what the note of the log says: a scene that was not made by a
 * program known here cannot be. */
#ifndef VBSS_EXAMPLES_REPORT_STAGE_H
#define VBSS_EXAMPLES_REPORT_STAGE_H

#include "report/facts.h"

struct stand;

typedef struct stage {
    const char *name;
    struct stand *stand; /* whose context all is in */
    vbss_context *context;
    vbss_scene *scene;
    vbss_grasper *graspers[SIDES];
    vbss_drain *drain; /* may be NULL */
    double tube;       /* its middle radius, m */
    uint32_t needle;   /* body; 0: none */
    vbss_knot_detector *detector;
} stage;

/* False: the note names no scene that is known. */
bool stage_knows(const void *note, size_t count);
vbss_result stage_create(stage *s, const void *note, size_t count);
/* After a step: which thread it is now, if it was cut. */
vbss_result stage_follow(stage *s);
vbss_result stage_judge(stage *s, reading *r);
void stage_destroy(stage *s);

#endif
