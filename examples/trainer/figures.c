#include "trainer/figures.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "throw/vec.h"

const int figures_bins[BINS] = {10, 20, 50, 100, 200, 500, 1000, 2000, 0};

static void count(uint64_t bins[BINS], double seconds)
{
    int i = 0;
    while (i < BINS - 1 && 1e6 * seconds >= figures_bins[i]) {
        i++;
    }
    bins[i]++;
}

void figures_slot(figures *f, double period, double work, double late, double wall)
{
    f->slots++;
    count(f->work, work);
    count(f->late, late);
    f->total_work += work;
    f->worst_work = larger(f->worst_work, work);
    f->worst_late = larger(f->worst_late, late);
    f->our_misses += work > period;
    f->wall_misses += wall > period;
}

void figures_note(figures *f, bool fault, const char *format, ...)
{
    va_list list;
    f->faults += fault;
    if (f->event_count == MAX_EVENTS) {
        f->events_lost++;
        return;
    }
    event *e = &f->events[f->event_count++];
    e->time = f->time;
    va_start(list, format);
    (void)vsnprintf(e->text, sizeof e->text, format, list);
    va_end(list);
}

/* ---- the exchange */

#define FRESH 4u

void exchange_init(exchange *e)
{
    memset(e->copies, 0, sizeof e->copies);
    e->back = 0;
    e->front = 2;
    atomic_init(&e->middle, 1u);
}

void exchange_put(exchange *e, const figures *f)
{
    e->copies[e->back] = *f;
    e->back = atomic_exchange_explicit(&e->middle, e->back | FRESH, memory_order_acq_rel) & 3u;
}

const figures *exchange_take(exchange *e)
{
    if ((atomic_load_explicit(&e->middle, memory_order_relaxed) & FRESH) != 0) {
        e->front = atomic_exchange_explicit(&e->middle, e->front, memory_order_acq_rel) & 3u;
    }
    return &e->copies[e->front];
}
