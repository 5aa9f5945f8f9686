/* Functional mock-up unit of a loss map: FMI 2.0, model exchange and co-simulation, no states. The tables C (temperature,
   degC), T (torque, N m), W (speed, rad/s), MESH, ADDED and PARTS (loss torque, N m, temperature by temperature and torque
   by torque, PARTS mesh by mesh) and their sizes NC, NT, NW and NP are above. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

typedef void *Component;
typedef unsigned int Reference;
typedef int Status;
enum { OK = 0, ERROR = 3 };
enum { TAU, OMEGA, LOSS_TORQUE, LOSS_POWER, OUTSIDE, MESH_TORQUE, ADDED_TORQUE, TEMPERATURE, PART_TORQUE,
       VARIABLES = PART_TORQUE + NP };
typedef struct { double v[VARIABLES]; } Model;

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/* Nearest torque of the table. */
static double edge(double x) { return x < T[0] ? T[0] : x > T[NT - 1] ? T[NT - 1] : x; }

/* Node below x; the last cell beyond the end. */
static int cell(const double *nodes, int count, double x) {
    int i = 1;
    while (i < count - 1 && x > nodes[i]) i++;
    return i - 1;
}

static double share(const double *nodes, int i, double x) {
    double s = (x - nodes[i]) / (nodes[i + 1] - nodes[i]);
    return s < 0 ? 0 : s > 1 ? 1 : s;
}

static double plane(const double *table, int i, int j, double a, double b) {
    const double *low = table + (size_t)i * NW + j, *high = low + NW;
    return (1 - a) * ((1 - b) * low[0] + b * low[1]) + a * ((1 - b) * high[0] + b * high[1]);
}

/* A place in the tables: cells of temperature, torque and speed with the shares in them. */
typedef struct { int k, i, j; double c, a, b; } Place;

static double between(const double *table, const Place *p) {
    const double *low = table + (size_t)p->k * NT * NW;
    double value = plane(low, p->i, p->j, p->a, p->b);
    if (p->c == 0) return value;
    return (1 - p->c) * value + p->c * plane(low + (size_t)NT * NW, p->i, p->j, p->a, p->b);
}

/* Outside the table loss over torque is held: the loss of the edge times the torque over that of the edge. A direction of
   the torque that the table does not have takes the losses of the other one; a negative speed has those of the same power at
   the positive speed. Outside the temperatures the loss of the
   nearest one is held. */
static void evaluate(Model *m) {
    Place p = {0, 0, 0, 0, 0, 0};
    int part;
    int is_reverse = m->v[OMEGA] < 0;
    double tau = is_reverse ? -m->v[TAU] : m->v[TAU], y = is_reverse ? -m->v[OMEGA] : m->v[OMEGA];
    int is_other = (tau < 0 && T[0] >= 0) || (tau > 0 && T[NT - 1] <= 0);
    double t = is_other ? -tau : tau, x = edge(t), factor = x == t || x == 0 ? 1 : t / x;
    p.i = cell(T, NT, x);
    p.j = cell(W, NW, y);
    p.a = share(T, p.i, x);
    p.b = share(W, p.j, y);
    if (NC > 1) {
        p.k = cell(C, NC, m->v[TEMPERATURE]);
        p.c = share(C, p.k, m->v[TEMPERATURE]);
    }
    if (factor < 0) factor = -factor;
    m->v[MESH_TORQUE] = factor * between(MESH, &p);
    m->v[ADDED_TORQUE] = factor * between(ADDED, &p);
    for (part = 0; part < NP; part++)
        m->v[PART_TORQUE + part] = factor * between(PARTS + (size_t)part * NC * NT * NW, &p);
    m->v[LOSS_TORQUE] = m->v[MESH_TORQUE] + m->v[ADDED_TORQUE];
    m->v[LOSS_POWER] = m->v[LOSS_TORQUE] * y;
    /* Written so that what is no number is outside. */
    m->v[OUTSIDE] = !(tau >= T[0] && tau <= T[NT - 1] && y <= W[NW - 1]
                      && m->v[TEMPERATURE] >= C[0] && m->v[TEMPERATURE] <= C[NC - 1]);
}

static void begin(Model *m) {
    memset(m, 0, sizeof(Model));
    m->v[TEMPERATURE] = C[0];
}

EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
EXPORT Component fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                                 const void *functions, int visible, int logging) {
    Model *m;
    (void)name; (void)type; (void)resources; (void)functions; (void)visible; (void)logging;
    if (!guid || strcmp(guid, GUID)) return NULL;
    m = malloc(sizeof(Model));
    if (!m) return NULL;
    begin(m);
    evaluate(m);
    return m;
}
EXPORT void fmi2FreeInstance(Component c) { free(c); }
EXPORT Status fmi2GetReal(Component c, const Reference *r, size_t n, double *values) {
    Model *m = c;
    size_t k;
    evaluate(m);
    for (k = 0; k < n; k++) {
        if (r[k] >= VARIABLES) return ERROR;
        values[k] = m->v[r[k]];
    }
    return OK;
}
EXPORT Status fmi2SetReal(Component c, const Reference *r, size_t n, const double *values) {
    Model *m = c;
    size_t k;
    for (k = 0; k < n; k++) {
        if (r[k] > OMEGA && (r[k] != TEMPERATURE || NC < 2)) return ERROR;
        m->v[r[k]] = values[k];
    }
    return OK;
}
EXPORT Status fmi2SetupExperiment(Component c, int has_tolerance, double tolerance, double start, int has_stop, double stop) {
    (void)c; (void)has_tolerance; (void)tolerance; (void)start; (void)has_stop; (void)stop;
    return OK;
}
EXPORT Status fmi2DoStep(Component c, double time, double step, int no_set_state) {
    (void)c; (void)time; (void)step; (void)no_set_state;
    return OK;
}
EXPORT Status fmi2SetTime(Component c, double time) { (void)c; (void)time; return OK; }
EXPORT Status fmi2NewDiscreteStates(Component c, int *info) {
    (void)c;
    memset(info, 0, 5 * sizeof(int));
    return OK;
}
EXPORT Status fmi2CompletedIntegratorStep(Component c, int no_set_state, int *event, int *terminate) {
    (void)c; (void)no_set_state;
    *event = *terminate = 0;
    return OK;
}
EXPORT Status fmi2Reset(Component c) { begin(c); return OK; }

#define DOES_NOTHING(name) EXPORT Status name(Component c) { (void)c; return OK; }
DOES_NOTHING(fmi2EnterInitializationMode)
DOES_NOTHING(fmi2ExitInitializationMode)
DOES_NOTHING(fmi2Terminate)
DOES_NOTHING(fmi2EnterEventMode)
DOES_NOTHING(fmi2EnterContinuousTimeMode)

/* No states. */
#define NO_STATES(name) EXPORT Status name(Component c, double *x, size_t n) { (void)c; (void)x; (void)n; return OK; }
NO_STATES(fmi2GetDerivatives)
NO_STATES(fmi2GetEventIndicators)
NO_STATES(fmi2GetContinuousStates)
NO_STATES(fmi2GetNominalsOfContinuousStates)
EXPORT Status fmi2SetContinuousStates(Component c, const double *x, size_t n) { (void)c; (void)x; (void)n; return OK; }

/* Importers load every function of the standard; these have nothing to tell here. */
EXPORT Status fmi2SetDebugLogging(Component c, int on, size_t n, const char *const *names) {
    (void)c; (void)on; (void)n; (void)names;
    return OK;
}
#define REFUSES(name, arguments) EXPORT Status name arguments { return ERROR; }
REFUSES(fmi2GetInteger, (Component c, const Reference *r, size_t n, int *v))
REFUSES(fmi2GetBoolean, (Component c, const Reference *r, size_t n, int *v))
REFUSES(fmi2GetString, (Component c, const Reference *r, size_t n, const char **v))
REFUSES(fmi2SetInteger, (Component c, const Reference *r, size_t n, const int *v))
REFUSES(fmi2SetBoolean, (Component c, const Reference *r, size_t n, const int *v))
REFUSES(fmi2SetString, (Component c, const Reference *r, size_t n, const char *const *v))
REFUSES(fmi2CancelStep, (Component c))
REFUSES(fmi2GetStatus, (Component c, int kind, Status *v))
REFUSES(fmi2GetRealStatus, (Component c, int kind, double *v))
REFUSES(fmi2GetIntegerStatus, (Component c, int kind, int *v))
REFUSES(fmi2GetBooleanStatus, (Component c, int kind, int *v))
REFUSES(fmi2GetStringStatus, (Component c, int kind, const char **v))
REFUSES(fmi2SetRealInputDerivatives, (Component c, const Reference *r, size_t n, const int *o, const double *v))
REFUSES(fmi2GetRealOutputDerivatives, (Component c, const Reference *r, size_t n, const int *o, double *v))
REFUSES(fmi2GetFMUstate, (Component c, void **state))
REFUSES(fmi2SetFMUstate, (Component c, void *state))
REFUSES(fmi2FreeFMUstate, (Component c, void **state))
REFUSES(fmi2SerializedFMUstateSize, (Component c, void *state, size_t *n))
REFUSES(fmi2SerializeFMUstate, (Component c, void *state, char *bytes, size_t n))
REFUSES(fmi2DeSerializeFMUstate, (Component c, const char *bytes, size_t n, void **state))
REFUSES(fmi2GetDirectionalDerivative, (Component c, const Reference *u, size_t nu, const Reference *k, size_t nk, const double *du, double *dk))
