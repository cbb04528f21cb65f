/* The parts of the page; each writes one section. */
#ifndef VBSS_EXAMPLES_REPORT_PAGE_H
#define VBSS_EXAMPLES_REPORT_PAGE_H

#include "report/facts.h"
#include "report/text.h"

enum { MAX_PICTURES = 24 };

typedef struct picture {
    char name[256];
    uint8_t *bytes;
    size_t count;
} picture;

typedef struct pictures {
    picture all[MAX_PICTURES];
    size_t count, left_out; /* too many, too large, or no PNG */
    const char *folder;     /* NULL: none was named */
} pictures;

/* Reads the PNG files of a folder, by name; false: it cannot be read. */
bool pictures_read(pictures *p, const char *folder);
void pictures_free(pictures *p);

/* Pieces, to be put as they stand; NULL ends them. */
extern const char *const page_style[];

/* Writes the whole page; false: the file cannot be written, or memory was short. (whole.c) */
bool page_report(const facts *f, const pictures *shown, const char *to);

void page_head(page *p, const facts *f); /* page.c */
void page_foot(page *p, const facts *f, const pictures *shown);
void page_summary(page *p, const facts *f);     /* summary.c */
void page_debrief(page *p, const facts *f);     /* debrief.c */
void page_timeline(page *p, const facts *f);    /* timeline.c */
void page_session(page *p, const facts *f);     /* session.c: in the timeline */
void page_bands(page *p, const facts *f);       /* bands.c */
void page_motion(page *p, const facts *f);      /* curves.c */
void page_accuracy(page *p, const facts *f);    /* accuracy.c */
void page_knot(page *p, const facts *f);        /* knot.c */
void page_simulation(page *p, const facts *f);  /* simulation.c */
void page_pictures(page *p, const pictures *s); /* pictures.c */

/* Whether the trial went on is not known where the log is cut off before its end. */
static inline bool page_may_go_on(const facts *f)
{
    return f->check.result != VBSS_OK &&
           (f->measured.report.flags & VBSS_METRICS_FLAG_STOPPED) == 0;
}

static inline const char *page_side(int side)
{
    return side == LEFT ? "left" : "right";
}

#endif
