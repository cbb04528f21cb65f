/* A scripted surgeon makes a stitch:
 *
 *     surgeon [-s seed] [-u pass|pull|tie: the last stage] [-t most seconds] [-w limit of work of a step, -1: none]
 *             [-l log] [-p folder for pictures] [-e seconds between them] [-v]
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "surgeon/surgeon.h"

#define STEP 1e-3
#define MILLI 1e3

typedef struct told {
    surgeon_options o;
    double most, every;
    const char *folder;
    bool verbose;
} told;

static void tell(const surgeon *s, const char *doing)
{
    const stitch *t = &s->stitch;
    vbss_scene_statistics c;
    vbss_view x;
    vbss_needle_state needle;
    (void)vbss_scene_get_statistics(t->site.stand.scene, &c, sizeof c);
    (void)vbss_thread_get_view(t->site.stand.thread, VBSS_THREAD_POSITIONS, &x, sizeof x);
    (void)vbss_needle_get_state(t->site.needle, &needle, sizeof needle);
    const vec *n = x.data;
    printf("%7.3f %-7s tail %6.1f gap %5.2f L %5.1f %5.1f %5.1f R %5.1f %5.1f %5.1f pull %5.2f "
           "%5.2f needle %5.1f %5.1f %5.1f end %5.1f %5.1f %5.1f turns %5.2f phi %6.1f rho %4.1f Tw %5.3f Tc %5.3f first %u %.1f last %u %.1f paused %lu clamped %lu\n",
           t->site.stand.time, doing, MILLI * s->pull.tail, MILLI * s->gap, MILLI * t->left.at.x,
           MILLI * t->left.at.y, MILLI * t->left.at.z, MILLI * t->right.at.x,
           MILLI * t->right.at.y, MILLI * t->right.at.z, v_length(t->left.pull),
           v_length(t->right.pull), MILLI * needle.position[0], MILLI * needle.position[1],
           MILLI * needle.position[2], MILLI * n[x.count - 1].x, MILLI * n[x.count - 1].y,
           MILLI * n[x.count - 1].z, s->see.turns, s->tie.phi * 57.3, s->tie.rho * 1e3, s->see.tension_w, s->see.tension_c,
           s->see.first, s->see.first_s * 1e3, s->see.last, s->see.last_s * 1e3,
           (unsigned long)c.paused, (unsigned long)c.clamped);
    fflush(stdout);
}

static bool paint(const surgeon *s, const told *w, int number, const char *doing)
{
    char path[512], text[96];
    vec middle = s->stage == SURGEON_PASS ? v3(0.0, 0.0, 0.0) : v3(0.0, 0.0, 0.04);
    snprintf(path, sizeof path, "%s/%03d-%s.png", w->folder, number, doing);
    snprintf(text, sizeof text, "%.2f s, seed %lu: %s, tail %.1f mm, slit %.2f mm",
             s->stitch.site.stand.time, (unsigned long)w->o.seed, doing, MILLI * s->pull.tail,
             MILLI * s->gap);
    return surgeon_show(s, path, text, middle, s->stage == SURGEON_PASS ? 0.06 : 0.14);
}

static vbss_result run(surgeon *s, const told *w)
{
    const char *before = "";
    double next = 0.0;
    int pictures = 0;
    TRY(surgeon_create(s, &w->o));
    while (s->stage < w->o.until && s->stage < SURGEON_DONE && s->stitch.site.stand.time < w->most) {
        TRY(surgeon_step(s, STEP));
        const char *doing = surgeon_doing(s);
        bool changed = strcmp(doing, before) != 0;
        before = doing;
        if (w->verbose && (changed || s->steps % 200 == 0)) {
            tell(s, doing);
        }
        if (w->folder != NULL && (changed || s->stitch.site.stand.time >= next)) {
            (void)paint(s, w, pictures++, doing);
            next = s->stitch.site.stand.time + w->every;
        }
    }
    return stand_end(&s->stitch.site.stand);
}

int main(int count, char **words)
{
    static surgeon s;
    told w = {.o = {.until = SURGEON_DONE}, .most = 60.0, .every = 1e9};
    for (int i = 1; i < count; i++) {
        const char *word = words[i], *value = i + 1 < count ? words[i + 1] : "";
        switch (word[0] == '-' ? word[1] : 0) {
        case 'v':
            w.verbose = true;
            continue;
        case 's':
            w.o.seed = strtoul(value, NULL, 10);
            break;
        case 'u':
            w.o.until = value[0] == 't' ? SURGEON_DONE : value[1] == 'a' ? SURGEON_PULL : SURGEON_TIE;
            break;
        case 't':
            w.most = strtod(value, NULL);
            break;
        case 'w':
            w.o.work = atoi(value);
            break;
        case 'l':
            w.o.log = value;
            break;
        case 'p':
            w.folder = value;
            break;
        case 'e':
            w.every = strtod(value, NULL);
            break;
        default:
            fprintf(stderr, "surgeon [-s seed] [-u pass|pull|tie] [-t most seconds] [-w work] [-l log] "
                            "[-p folder] [-e seconds] [-v]\n");
            return 2;
        }
        i++;
    }
    clock_t begin = clock();
    vbss_result result = run(&s, &w);
    printf("seed %lu: %s %s %s %.2f s, tail %.1f mm, slit %.2f mm before, %.2f mm, cpu %.1f s\n",
           (unsigned long)w.o.seed, vbss_result_name(result), surgeon_doing(&s),
           s.why != NULL ? s.why : "", s.stitch.site.stand.time, MILLI * s.pull.tail,
           MILLI * s.gap_before, MILLI * s.gap, (double)(clock() - begin) / CLOCKS_PER_SEC);
    bool good = result == VBSS_OK && s.stage >= w.o.until && s.stage != SURGEON_FAILED;
    stand_destroy(&s.stitch.site.stand);
    return good ? 0 : 1;
}
