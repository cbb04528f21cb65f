/* Elimination order of a drain's nodes: minimum degree, and of equals the first node. A tube has no
 * end to begin at, so no natural order is better (docs/explanation/drain.md). Anchored nodes have no equation
 * and come last. When they tear off they have their place, at the cost of some fill-in. */
#include "base/error.h"
#include "drain/drain.h"

#include <string.h>

/* Adjacency of nodes, as rows of bits. */
typedef struct graph {
    uint32_t nodes, words;
    uint64_t *bits;
    uint32_t *degree;
    uint8_t *left;
} graph;

static uint64_t *row_of(const graph *g, uint32_t node)
{
    return g->bits + (size_t)node * g->words;
}

static bool are_adjacent(const graph *g, uint32_t a, uint32_t b)
{
    return (row_of(g, a)[b / 64] >> (b % 64) & 1u) != 0;
}

static void connect_nodes(graph *g, uint32_t a, uint32_t b)
{
    if (a != b && !are_adjacent(g, a, b)) {
        row_of(g, a)[b / 64] |= UINT64_C(1) << (b % 64);
        row_of(g, b)[a / 64] |= UINT64_C(1) << (a % 64);
        g->degree[a]++;
        g->degree[b]++;
    }
}

static vbss_result create_graph(vbss_context *context, uint32_t nodes, graph *g)
{
    *g = (graph){.nodes = nodes, .words = (nodes + 63) / 64};
    g->bits = vbss_allocate(context, (size_t)nodes * g->words, sizeof *g->bits, "order of a drain");
    g->degree = vbss_allocate(context, nodes, sizeof *g->degree, "order of a drain");
    g->left = vbss_allocate(context, nodes, sizeof *g->left, "order of a drain");
    return g->bits != NULL && g->degree != NULL && g->left != NULL ? VBSS_OK
                                                                   : VBSS_ERROR_OUT_OF_MEMORY;
}

static void destroy_graph(vbss_context *context, graph *g)
{
    vbss_release(context, g->bits, (size_t)g->nodes * g->words, sizeof *g->bits);
    vbss_release(context, g->degree, g->nodes, sizeof *g->degree);
    vbss_release(context, g->left, g->nodes, sizeof *g->left);
}

/* Connects the remaining nodes of each patch. */
static void connect_patches(graph *g, const drain_mesh *mesh, const vbss_shell *shell)
{
    memset(g->bits, 0, (size_t)g->nodes * g->words * sizeof *g->bits);
    memset(g->degree, 0, g->nodes * sizeof *g->degree);
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        for (uint32_t p = 0; p < SHELL_PAIRS; p++) {
            uint32_t a, b;
            if (vbss_shell_pair_nodes(shell, t, p, &a, &b) && g->left[a] && g->left[b]) {
                connect_nodes(g, a, b);
            }
        }
    }
}

/* Eliminates a node: its neighbours become neighbours of each other. */
static void eliminate(graph *g, uint32_t node)
{
    const uint64_t *gone = row_of(g, node);
    g->left[node] = false;
    for (uint32_t a = 0; a < g->nodes; a++) {
        if (!g->left[a] || !are_adjacent(g, node, a)) {
            continue;
        }
        uint64_t *row = row_of(g, a);
        g->degree[a] = 0;
        for (uint32_t w = 0; w < g->words; w++) {
            row[w] |= gone[w];
        }
        row[a / 64] &= ~(UINT64_C(1) << (a % 64));
        row[node / 64] &= ~(UINT64_C(1) << (node % 64));
        for (uint32_t b = 0; b < g->nodes; b++) {
            g->degree[a] += are_adjacent(g, a, b);
        }
    }
}

static uint32_t min_degree_node(const graph *g)
{
    uint32_t best = UINT32_MAX;
    for (uint32_t a = 0; a < g->nodes; a++) {
        if (g->left[a] && (best == UINT32_MAX || g->degree[a] < g->degree[best])) {
            best = a;
        }
    }
    return best;
}

static void order_nodes(graph *g, const drain_mesh *mesh, const vbss_shell *shell,
                        drain_elimination_order *order)
{
    uint32_t free_count = g->nodes - mesh->anchor_count;
    memset(g->left, 1, g->nodes);
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        g->left[mesh->anchors[i]] = 0;
        order->node[free_count + i] = mesh->anchors[i];
    }
    connect_patches(g, mesh, shell);
    for (uint32_t k = 0; k < free_count; k++) {
        order->node[k] = min_degree_node(g);
        eliminate(g, order->node[k]);
    }
    for (uint32_t k = 0; k < g->nodes; k++) {
        order->block_index[order->node[k]] = k;
    }
}

/* Counts the entries of the factor when all anchors have torn. */
static void count_fill(graph *g, const drain_mesh *mesh, const vbss_shell *shell,
                       drain_elimination_order *order)
{
    memset(g->left, 1, g->nodes);
    connect_patches(g, mesh, shell);
    order->factor_entries = order->factor_products = 0;
    for (uint32_t k = 0; k < g->nodes; k++) {
        uint32_t degree = g->degree[order->node[k]];
        order->factor_entries += degree;
        order->factor_products += degree * (degree - (degree > 0)) / 2;
        eliminate(g, order->node[k]);
    }
}

/* ---- pairs of nodes */

static uint32_t count_pairs(const graph *g)
{
    uint32_t sum = 0;
    for (uint32_t a = 0; a < g->nodes; a++) {
        sum += g->degree[a];
    }
    return sum / 2;
}

/* Bisects the list, which is sorted by the lower position, then the higher. */
static uint32_t find_pair(const drain_elimination_order *order, uint32_t high, uint32_t low)
{
    uint32_t from = 0, to = order->pair_count;
    while (to - from > 1) {
        uint32_t middle = from + (to - from) / 2;
        const drain_pair *p = &order->pairs[middle];
        bool after = p->low > low || (p->low == low && p->high > high);
        from = after ? from : middle;
        to = after ? middle : to;
    }
    return from;
}

static void list_pairs(const graph *g, drain_elimination_order *order)
{
    uint32_t count = 0;
    for (uint32_t low = 0; low < g->nodes; low++) {
        for (uint32_t high = low + 1; high < g->nodes; high++) {
            if (are_adjacent(g, order->node[low], order->node[high])) {
                order->pairs[count++] = (drain_pair){high, low, VBSS_NO_COUPLING};
            }
        }
    }
}

static void find_pairs_of_patches(const drain_mesh *mesh, const vbss_shell *shell,
                                  drain_elimination_order *order)
{
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        for (uint32_t p = 0; p < SHELL_PAIRS; p++) {
            uint32_t a, b;
            order->pair_codes[t][p] = 2 * order->pair_count;
            if (vbss_shell_pair_nodes(shell, t, p, &a, &b)) {
                uint32_t i = order->block_index[a], j = order->block_index[b];
                uint32_t pair = find_pair(order, i > j ? i : j, i > j ? j : i);
                order->pair_codes[t][p] = 2 * pair + (i < j);
            }
        }
    }
}

/* ---- the whole order */

static vbss_result build_order(vbss_context *context, const drain_mesh *mesh,
                               const vbss_shell *shell, graph *g, drain_elimination_order *order)
{
    uint32_t nodes = mesh->node_count;
    VBSS_TRY(create_graph(context, nodes, g));
    memset(g->left, 1, nodes);
    connect_patches(g, mesh, shell);
    order->pair_count = count_pairs(g);
    order->block_index =
        vbss_allocate(context, nodes, sizeof *order->block_index, "order of a drain");
    order->node = vbss_allocate(context, nodes, sizeof *order->node, "order of a drain");
    order->pairs =
        vbss_allocate(context, order->pair_count, sizeof *order->pairs, "order of a drain");
    order->pair_codes =
        vbss_allocate(context, mesh->triangle_count, sizeof *order->pair_codes, "order of a drain");
    order->block_codes = vbss_allocate(context, (size_t)order->pair_count + 1,
                                       sizeof *order->block_codes, "order of a drain");
    if (order->block_index == NULL || order->node == NULL || order->pairs == NULL ||
        order->pair_codes == NULL || order->block_codes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    order_nodes(g, mesh, shell, order);
    count_fill(g, mesh, shell, order);
    memset(g->left, 1, nodes);
    /* The elimination above has added fill-in. */
    connect_patches(g, mesh, shell);
    list_pairs(g, order);
    find_pairs_of_patches(mesh, shell, order);
    return VBSS_OK;
}

vbss_result vbss_drain_create_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                                const vbss_shell *shell,
                                                drain_elimination_order *order)
{
    graph g;
    vbss_result result = build_order(context, mesh, shell, &g, order);
    destroy_graph(context, &g);
    return result;
}

void vbss_drain_destroy_elimination_order(vbss_context *context, const drain_mesh *mesh,
                                          drain_elimination_order *order)
{
    vbss_release(context, order->block_index, mesh->node_count, sizeof *order->block_index);
    vbss_release(context, order->node, mesh->node_count, sizeof *order->node);
    vbss_release(context, order->pairs, order->pair_count, sizeof *order->pairs);
    vbss_release(context, order->pair_codes, mesh->triangle_count, sizeof *order->pair_codes);
    vbss_release(context, order->block_codes, (size_t)order->pair_count + 1,
                 sizeof *order->block_codes);
}
