/* Outliers: samples that no hand can have reached. They are counted and left out; the curve bridges
 * them as it does lost samples. */
#include "metrics/metrics.h"
#include "metrics/tuning.h"

static bool is_reachable(const vbss_metrics_config *c, double distance, double duration)
{
    return c->max_speed == 0.0 || distance <= METRICS_OUTLIER_TOLERANCE + c->max_speed * duration;
}

/* A sample that the tool can have reached from the last outlier with less speed than from the last
 * point is an outlier, too. Thus a lasting jump never becomes motion: the run ends instead. */
bool vbss_metrics_is_outlier(const vbss_metrics_config *c, const metrics_hand *h, double time,
                             vec3 position)
{
    uint32_t last = h->point_count - 1;
    double duration = time - h->time[last];
    double distance = vec3_distance(position, h->position[last]);
    if (!is_reachable(c, distance, duration)) {
        return true;
    }
    double outlier_distance = vec3_distance(position, h->outlier);
    return h->has_outlier != 0 && outlier_distance * duration < distance * (time - h->outlier_time);
}

void vbss_metrics_keep_outlier(metrics_hand *h, double time, vec3 position)
{
    h->has_outlier = 1;
    h->outlier_time = time;
    h->outlier = position;
    h->outlier_count++;
}
