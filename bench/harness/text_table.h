/* A table of short texts, printed aligned; columns that stay empty are left out. */
#ifndef VBSS_BENCH_HARNESS_TEXT_TABLE_H
#define VBSS_BENCH_HARNESS_TEXT_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { TEXT_CELL_SIZE = 64 };

typedef struct text_table {
    size_t rows, columns, row_capacity, column_capacity;
    char (*heads)[TEXT_CELL_SIZE];
    char (*cells)[TEXT_CELL_SIZE]; /* row by row, column_capacity apart */
    bool *gaps;                    /* an empty line before the row */
} text_table;

/* False when there is no memory. */
bool text_table_create(text_table *table, size_t row_capacity, size_t column_capacity);
void text_table_destroy(text_table *table);
/* The column with that head, added when it is new; the last one once the capacity is used up. */
size_t text_table_column(text_table *table, const char *head);
/* Starts the next row. The capacity must not be exceeded. */
void text_table_row(text_table *table, bool gap);
/* Into the current row. */
void text_table_set(text_table *table, size_t column, const char *text);
/* A number with about four digits; NaN leaves the cell empty. */
void text_table_set_number(text_table *table, size_t column, double value);
/* The columns 0 .. left - 1 are aligned to the left, the others to the right. */
void text_table_print(const text_table *table, size_t left, FILE *file);

#endif
