#include "knot/paper_rig.h"

#include <stdlib.h>
#include <string.h>

void paper_rig_begin(paper_rig *rig)
{
    *rig = (paper_rig){.config = {.struct_size = sizeof rig->config,
                                  .method = VBSS_KNOT_METHOD_PROJECTION,
                                  .point_capacity = PAPER_RIG_POINTS}};
    for (int k = 0; k < PAPER_RIG_TOOLS; k++) {
        rig->tools[k].point_count = 2;
        rig->tools[k].axis[0] = vec3_make(0.0, 0.0, 0.15);
    }
    rig->paper.random = &rig->random;
    rig->scene.points = rig->points;
    rig->scene.tools = rig->tools;
    rig->scene.tool_count = PAPER_RIG_TOOLS;
    vbss_array arrays[BASELINE_LOOP_ARRAYS];
    vbss_baseline_list_loop_arrays(&rig->paper, PAPER_RIG_POINTS, arrays);
    for (int k = 0; k < BASELINE_LOOP_ARRAYS; k++) {
        void *block = calloc(arrays[k].count, arrays[k].size);
        assert_non_null(block);
        memcpy(arrays[k].pointer, &block, sizeof block);
    }
}

void paper_rig_end(paper_rig *rig)
{
    free(rig->paper.loops);
    free(rig->paper.flat);
}

void paper_rig_show(paper_rig *rig, const double (*mm)[3], uint32_t count)
{
    assert_true(count <= PAPER_RIG_POINTS);
    for (uint32_t k = 0; k < count; k++) {
        rig->points[k] = vec3_scale(vec3_load(mm[k]), 1e-3);
    }
    rig->scene.point_count = count;
}

void paper_rig_reverse(paper_rig *rig)
{
    uint32_t n = rig->scene.point_count;
    for (uint32_t k = 0; k < n / 2; k++) {
        vec3 swapped = rig->points[k];
        rig->points[k] = rig->points[n - 1 - k];
        rig->points[n - 1 - k] = swapped;
    }
}

uint32_t paper_rig_loops(paper_rig *rig, uint64_t seed)
{
    vbss_random_seed(&rig->random, seed, 0);
    rig->paper.loop_count = 0;
    vbss_baseline_find_loops(&rig->paper, &rig->config, &rig->scene, 0);
    return rig->paper.loop_count;
}

uint32_t paper_rig_inside(const paper_rig *rig)
{
    uint32_t inside = 0;
    for (uint32_t k = 0; k < rig->paper.loop_count; k++) {
        inside += rig->paper.loops[k].inside;
    }
    return inside;
}

baseline_throw paper_rig_throws(paper_rig *rig, uint64_t seed)
{
    paper_rig_loops(rig, seed);
    return vbss_baseline_find_throws(&rig->paper, &rig->config, &rig->scene, 0);
}
