/* The begin of the page and its end: where all this comes from, and what is not in it. */
#include <string.h>

#include "report/page.h"

/* The last part of a path. */
static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static void put_faults(page *p, const facts *f)
{
    const vbss_record_log_report *c = &f->check;
    if (c->result == VBSS_OK) {
        return;
    }
    put(p,
        "<p class=\"banner\" role=\"note\"><strong>%s.</strong> This report is of its good part: "
        "%llu steps, %.3f s, %llu of %llu bytes.",
        c->result == VBSS_ERROR_TRUNCATED ? "The log is cut off" : "The log is damaged",
        (unsigned long long)c->steps, c->time, (unsigned long long)c->good_bytes,
        (unsigned long long)c->log_bytes);
    for (uint32_t i = 0; i < c->fault_count && i < 8; i++) {
        put(p, " Byte %llu: ", (unsigned long long)c->fault_positions[i]);
        put_text(p, c->fault_problems[i]);
        put(p, ".");
    }
    put(p, "</p>\n");
}

/* The trial's share; a log without a trial has none. */
static void put_lost_time(page *p, const facts *f)
{
    const vbss_metrics_report *r = &f->measured.report;
    if ((r->flags & VBSS_METRICS_FLAG_TIME_LOST) == 0) {
        return;
    }
    put(p,
        "<p class=\"banner\" role=\"note\"><strong>Simulated time was lost.</strong> Of %.2f s on "
        "the "
        "session clock %.2f s (%.0f %%) were left out, as steps exceeded their limits of work; "
        "%.2f s "
        "were simulated. Time, score and motion use the session clock, lost time included, and do "
        "not compare with those of other trials.</p>\n",
        r->time, r->time_lost, 100.0 * r->time_lost / r->time, r->time_simulated);
}

/* Which aids, and when, is in the list of events. */
static void put_assistance(page *p, const facts *f)
{
    if ((f->measured.report.flags & VBSS_METRICS_FLAG_ASSISTED) != 0) {
        put(p,
            "<p class=\"banner\" role=\"note\"><strong>The trainee was assisted.</strong> The "
            "trial gets no score. Time, forces and motion are those of assisted hands and do not "
            "compare with those of other trials.</p>\n");
    }
}

void page_head(page *p, const facts *f)
{
    const char *name = file_name(f->path);
    put(p,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\"/>\n<title>Session report: ");
    put_text(p, name);
    put(p, "</title>\n<style>\n");
    for (size_t i = 0; page_style[i] != NULL; i++) {
        put(p, "%s", page_style[i]);
    }
    put(p, "</style>\n</head>\n<body>\n<header>\n<h1>Session report</h1>\n<p><bdi>");
    put_text(p, name);
    put(p, "</bdi>: %llu steps, %.2f s on the session clock, %.2f s of it simulated</p>\n",
        (unsigned long long)f->steps, facts_end(f), facts_end(f) - f->check.time_lost);
    put_assistance(p, f);
    put_lost_time(p, f);
    put_faults(p, f);
    put(p, "</header>\n<main>\n");
}

/* ---- the end */

static void put_absent(page *p, bool absent, const char *words)
{
    if (absent) {
        put(p, "<li>%s</li>\n", words);
    }
}

static void put_limits(page *p, const facts *f)
{
    const again *a = &f->again;
    put(p, "<section aria-labelledby=\"limits\"><h2 id=\"limits\">What this report does not "
           "know</h2>\n<ul>\n");
    put_absent(p, true, "Who, when, and on which machine: logs do not hold it.");
    put_absent(p, !a->session.measured,
               "When the needle appeared: there is no such event in the log, so the clock "
               "starts with the log.");
    put_absent(p, f->measured.report.tightness_pull == VBSS_METRICS_TIGHTNESS_UNKNOWN,
               "Whether the knot holds: no pull test is in the log.");
    put_absent(p, !a->session.measured,
               "Lengths of the tails, and what was dropped: not worked out from the log.");
    put_absent(p, a->count == 0,
               "Forces, contacts, the thread, the drain and the knot: logs hold what the scene was "
               "told, and these come from playing that back, which was not done.");
    put_absent(p, a->count > 0 && a->count < f->steps,
               "Forces and all else that comes from playing back, after where that ended.");
    put_absent(p, a->count > 0 && !a->drain,
               "Punctures and the slit: this scene has no drain with "
               "walls.");
    put_absent(p, f->tools[LEFT] == 0 || f->tools[RIGHT] == 0,
               "Motion of a second tool: fewer than two were moved.");
    put_absent(p, f->others > 0,
               "Motion of further bodies that were moved: only two are taken for "
               "tools.");
    put(p, "</ul></section>\n");
}

static void put_tool(page *p, const facts *f, int side)
{
    put(p, "<dt>%s tool</dt><dd>", page_side(side));
    if (f->tools[side] != 0) {
        put(p, "body %u of the scene, %s", (unsigned)f->tools[side],
            side == LEFT
                ? "of the two that were moved most that which began more to the left (&#8722;x)"
                : "the other one");
    } else {
        put(p, "none was moved");
    }
    put(p, "</dd>\n");
}

static void put_source(page *p, const facts *f, const pictures *shown)
{
    put(p, "<section aria-labelledby=\"source\"><h2 id=\"source\">Where this comes from</h2>\n<dl>"
           "<dt>log</dt><dd><bdi>");
    put_text(p, f->path);
    put(p, "</bdi>, %llu bytes, %llu good; %llu inputs, %llu events, %llu snapshots</dd>\n",
        (unsigned long long)f->check.log_bytes, (unsigned long long)f->check.good_bytes,
        (unsigned long long)f->check.inputs, (unsigned long long)f->check.events,
        (unsigned long long)f->check.snapshots);
    put(p, "<dt>written by</dt><dd><bdi>");
    put_text(p, f->info.build_info);
    put(p, "</bdi></dd>\n<dt>its note</dt><dd><bdi>");
    if (f->info.note_bytes > 0) {
        put_bytes(p, f->info.note, f->info.note_bytes < 400 ? f->info.note_bytes : 400);
        put(p, "%s", f->info.note_bytes > 400 ? " &#8230;" : "");
    } else {
        put(p, "none");
    }
    put(p, "</bdi></dd>\n<dt>hashes</dt><dd>every %u steps</dd>\n<dt>report by</dt><dd>",
        (unsigned)f->info.hash_interval);
    put_text(p, vbss_build_info());
    put(p, "</dd>\n");
    put_tool(p, f, LEFT);
    put_tool(p, f, RIGHT);
    put(p, "<dt>pictures</dt><dd>");
    if (shown->folder != NULL) {
        put_text(p, shown->folder);
        put(p, ", as found there: the log does not name them");
    } else {
        put(p, "none were named");
    }
    put(p, "</dd></dl></section>\n");
}

void page_foot(page *p, const facts *f, const pictures *shown)
{
    put_limits(p, f);
    put_source(p, f, shown);
    put(p,
        "</main>\n<footer><p class=\"note\">For research and training; not a medical device. The "
        "score is in the style of MISTELS and not the FLS score.</p></footer>\n</body>\n</html>\n");
}
