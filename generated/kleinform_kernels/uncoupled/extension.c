/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
/* The kernels as NumPy's generalised ufuncs, and on single poses without their overhead.

   NumPy does the broadcasting, the casting, `out=`, and releases the GIL around the loop. The
   instructions that the loop uses are chosen once, when the module is imported. */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <fenv.h>
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <stdint.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "simd.h"
#include "table.h"

/* Numbers that go in and come out of a pose, and kernels, at most. */
#define GIVEN 32
#define RETURNED 192
#define KERNELS 64
/* Bytes of a pose, and of all poses, from which results are written past the caches. */
#define STREAMED_POSE 128
#define STREAMED (4 << 20)

extern const struct table kleinform_table_baseline;
#ifdef KLEINFORM_X86
extern const struct table kleinform_table_avx2;
extern const struct table kleinform_table_avx512;
#endif

static const struct kernel *active;
static size_t count;
static const char *instructions;

static void use(const char *name, const struct table *table)
{
    instructions = name;
    active = table->kernels;
    count = table->count;
}

/* Use the instructions of this name; 0 if this machine or this build has not got them. */
static int use_named(const char *name)
{
    if (!simd_supported(name))
        return 0;
#ifdef KLEINFORM_X86
    if (strcmp(name, "avx512") == 0)
        use("avx512", &kleinform_table_avx512);
    else if (strcmp(name, "avx2") == 0)
        use("avx2", &kleinform_table_avx2);
    else
#endif
        use("baseline", &kleinform_table_baseline);
    return 1;
}

/* The generalised ufunc ------------------------------------------------------------------ */

/* An argument: where its first pose is, how far the next one, and its entries. */
struct field {
    char *at;
    npy_intp pose;
    npy_intp row;
    npy_intp entry;
    int rows;
    int entries;
    /* The numbers of a pose, and those of all poses, one right after the other. */
    int packed;
    /* Packed, of matrices, and too large for the caches. */
    int streamed;
};

static void list_fields(
    const struct kernel *kernel, char **args, npy_intp poses, const npy_intp *steps,
    struct field *fields)
{
    const int count = kernel->inputs + kernel->outputs;
    const npy_intp *inner = steps + count;
    for (int k = 0; k < count; ++k) {
        const int *shape = kernel->shapes[k];
        struct field *field = fields + k;
        field->at = args[k];
        field->pose = steps[k];
        field->rows = shape[0] ? shape[0] : 1;
        field->entries = shape[1] ? shape[1] : 1;
        field->row = shape[0] ? *inner++ : 0;
        field->entry = shape[1] ? *inner++ : 0;
        const npy_intp row = field->entries * (npy_intp)sizeof(double);
        field->packed = (field->rows == 1 || field->row == row) &&
                        (field->entries == 1 || field->entry == (npy_intp)sizeof(double)) &&
                        field->pose == field->rows * row;
        field->streamed = field->packed && field->pose >= STREAMED_POSE &&
                          field->pose % 16 == 0 && (uintptr_t)field->at % 16 == 0 &&
                          poses >= STREAMED / field->pose;
    }
}

/* Poses that lie one after the other, to lanes that lie side by side, and back. */
INLINE void poses_to_lanes(const double *RESTRICT poses, int size, double *RESTRICT lanes)
{
    int k = 0;
#ifdef __SSE2__
    for (; k + 1 < size; k += 2)
        for (int lane = 0; lane < LANES; lane += 2) {
            const __m128d even = _mm_loadu_pd(poses + lane * size + k);
            const __m128d odd = _mm_loadu_pd(poses + (lane + 1) * size + k);
            _mm_store_pd(lanes + k * LANES + lane, _mm_unpacklo_pd(even, odd));
            _mm_store_pd(lanes + (k + 1) * LANES + lane, _mm_unpackhi_pd(even, odd));
        }
#endif
    for (; k < size; ++k)
        for (int lane = 0; lane < LANES; ++lane)
            lanes[k * LANES + lane] = poses[lane * size + k];
}

INLINE void lanes_to_poses(const double *RESTRICT lanes, int size, double *RESTRICT poses)
{
    int k = 0;
#ifdef __SSE2__
    for (; k + 1 < size; k += 2)
        for (int lane = 0; lane < LANES; lane += 2) {
            const __m128d first = _mm_load_pd(lanes + k * LANES + lane);
            const __m128d second = _mm_load_pd(lanes + (k + 1) * LANES + lane);
            _mm_storeu_pd(poses + lane * size + k, _mm_unpacklo_pd(first, second));
            _mm_storeu_pd(poses + (lane + 1) * size + k, _mm_unpackhi_pd(first, second));
        }
#endif
    for (; k < size; ++k)
        for (int lane = 0; lane < LANES; ++lane)
            poses[lane * size + k] = lanes[k * LANES + lane];
}

/* The same for the sizes that occur most, which compilers then know. */
static void to_lanes(const double *poses, int size, double *lanes)
{
    switch (size) {
    case 1:
        memcpy(lanes, poses, LANES * sizeof(double));
        break;
    case 3:
        poses_to_lanes(poses, 3, lanes);
        break;
    case 9:
        poses_to_lanes(poses, 9, lanes);
        break;
    default:
        poses_to_lanes(poses, size, lanes);
    }
}

static void to_poses(const double *lanes, int size, double *poses)
{
    switch (size) {
    case 1:
        memcpy(poses, lanes, LANES * sizeof(double));
        break;
    case 3:
        lanes_to_poses(lanes, 3, poses);
        break;
    case 6:
        lanes_to_poses(lanes, 6, poses);
        break;
    default:
        lanes_to_poses(lanes, size, poses);
    }
}

/* The same past the caches, for results that do not fit in them: memory is then written
   without having been read. */
INLINE void stream_poses(const double *RESTRICT lanes, int size, double *RESTRICT poses)
{
#ifdef __SSE2__
    for (int lane = 0; lane < LANES; lane += 2)
        for (int k = 0; k < size; k += 2) {
            const __m128d first = _mm_load_pd(lanes + k * LANES + lane);
            const __m128d second = _mm_load_pd(lanes + (k + 1) * LANES + lane);
            _mm_stream_pd(poses + lane * size + k, _mm_unpacklo_pd(first, second));
            _mm_stream_pd(poses + (lane + 1) * size + k, _mm_unpackhi_pd(first, second));
        }
#else
    lanes_to_poses(lanes, size, poses);
#endif
}

INLINE void gather(struct field *field, double *buffer, const int lanes)
{
    if (lanes == LANES && field->packed)
        to_lanes((const double *)field->at, field->rows * field->entries, buffer);
    else
        for (int i = 0; i < field->rows; ++i)
            for (int j = 0; j < field->entries; ++j, buffer += lanes) {
                const char *at = field->at + i * field->row + j * field->entry;
                if (field->pose == sizeof(double))
                    memcpy(buffer, at, (size_t)lanes * sizeof(double));
                else
                    for (int lane = 0; lane < lanes; ++lane)
                        buffer[lane] = *(const double *)(at + lane * field->pose);
            }
    field->at += lanes * field->pose;
}

INLINE void scatter(struct field *field, const double *buffer, const int lanes)
{
    if (lanes == LANES && field->streamed)
        stream_poses(buffer, field->rows * field->entries, (double *)field->at);
    else if (lanes == LANES && field->packed)
        to_poses(buffer, field->rows * field->entries, (double *)field->at);
    else
        for (int i = 0; i < field->rows; ++i)
            for (int j = 0; j < field->entries; ++j, buffer += lanes) {
                char *at = field->at + i * field->row + j * field->entry;
                if (field->pose == sizeof(double))
                    memcpy(at, buffer, (size_t)lanes * sizeof(double));
                else
                    for (int lane = 0; lane < lanes; ++lane)
                        *(double *)(at + lane * field->pose) = buffer[lane];
            }
    field->at += lanes * field->pose;
}

INLINE void advance(
    const struct kernel *kernel, struct field *fields, double *in, double *out, const int lanes)
{
    double *at = in;
    for (int k = 0; k < kernel->inputs; ++k) {
        gather(fields + k, at, lanes);
        at += fields[k].rows * fields[k].entries * lanes;
    }
    (lanes == LANES ? kernel->lanes : kernel->one)(in, out);
    at = out;
    for (int k = kernel->inputs; k < kernel->inputs + kernel->outputs; ++k) {
        scatter(fields + k, at, lanes);
        at += fields[k].rows * fields[k].entries * lanes;
    }
}

static void loop(char **args, const npy_intp *dimensions, const npy_intp *steps, void *data)
{
    const struct kernel *kernel = active + *(const size_t *)data;
    struct field fields[FIELDS];
    ALIGNED double in[GIVEN * LANES];
    ALIGNED double out[RETURNED * LANES];
    npy_intp left = dimensions[0];

    list_fields(kernel, args, left, steps, fields);
    for (; left >= LANES; left -= LANES)
        advance(kernel, fields, in, out, LANES);
    for (; left > 0; --left)
        advance(kernel, fields, in, out, 1);
#ifdef __SSE2__
    _mm_sfence();
#endif
    /* A singular pose gives inf or NaN, and no warning. */
    feclearexcept(FE_ALL_EXCEPT);
}

static size_t indices[KERNELS];
static PyUFuncGenericFunction loops[KERNELS][1];
static void *data[KERNELS][1];
static char types[FIELDS];

static PyObject *gufunc(size_t index)
{
    const struct kernel *kernel = active + index;
    indices[index] = index;
    loops[index][0] = (PyUFuncGenericFunction)loop;
    data[index][0] = &indices[index];
    return PyUFunc_FromFuncAndDataAndSignature(
        loops[index], data[index], types, 1, kernel->inputs, kernel->outputs, PyUFunc_None,
        kernel->name, kernel->words, 0, kernel->signature);
}

/* Single poses --------------------------------------------------------------------------- */

/* A kernel on one pose of float64 arrays: the named tuple of its results, or None for
   anything else. */
typedef struct {
    PyObject_HEAD
    vectorcallfunc call;
    size_t index;
    PyTypeObject *result;
} OnePose;

/* Copy a float64 array of this shape, or a Python float, to the buffer; false if it is none. */
static int read_field(PyObject *value, const int *shape, double *buffer)
{
    const int axes = shape[0] == 0 ? 0 : shape[1] == 0 ? 1 : 2;
    if (axes == 0 && PyFloat_CheckExact(value)) {
        *buffer = PyFloat_AS_DOUBLE(value);
        return 1;
    }
    if (!PyArray_CheckExact(value))
        return 0;
    PyArrayObject *array = (PyArrayObject *)value;
    if (PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISBEHAVED_RO(array) ||
        PyArray_NDIM(array) != axes)
        return 0;
    const char *at = PyArray_BYTES(array);
    const npy_intp *steps = PyArray_STRIDES(array);
    for (int axis = 0; axis < axes; ++axis)
        if (PyArray_DIM(array, axis) != shape[axis])
            return 0;
    for (int i = 0; i < (axes > 0 ? shape[0] : 1); ++i)
        for (int j = 0; j < (axes > 1 ? shape[1] : 1); ++j)
            *buffer++ = *(const double *)(at + (axes > 0 ? i * steps[0] : 0) +
                                          (axes > 1 ? j * steps[1] : 0));
    return 1;
}

static int count_of(const int *shape)
{
    return (shape[0] ? shape[0] : 1) * (shape[1] ? shape[1] : 1);
}

static PyObject *new_field(const int *shape, const double *values)
{
    const int axes = shape[0] == 0 ? 0 : shape[1] == 0 ? 1 : 2;
    npy_intp sizes[2] = {shape[0], shape[1]};
    PyObject *array = PyArray_SimpleNew(axes, sizes, NPY_DOUBLE);
    if (array)
        memcpy(PyArray_DATA((PyArrayObject *)array), values,
               (size_t)count_of(shape) * sizeof(double));
    return array;
}

static PyObject *new_result(PyTypeObject *type, const struct kernel *kernel, const double *out)
{
    PyObject *fields = PyTuple_New(kernel->outputs);
    if (!fields)
        return NULL;
    for (int field = 0; field < kernel->outputs; ++field) {
        const int *shape = kernel->shapes[kernel->inputs + field];
        PyObject *array = new_field(shape, out);
        if (!array) {
            Py_DECREF(fields);
            return NULL;
        }
        PyTuple_SET_ITEM(fields, field, array);
        out += count_of(shape);
    }
    PyObject *arguments = PyTuple_Pack(1, fields);
    Py_DECREF(fields);
    if (!arguments)
        return NULL;
    PyObject *result = PyTuple_Type.tp_new(type, arguments, NULL);
    Py_DECREF(arguments);
    return result;
}

static PyObject *one_pose_call(
    PyObject *callable, PyObject *const *args, size_t flags, PyObject *keywords)
{
    const OnePose *self = (const OnePose *)callable;
    const struct kernel *kernel = active + self->index;
    double in[GIVEN], out[RETURNED];
    double *at = in;
    if (keywords || PyVectorcall_NARGS(flags) != kernel->inputs)
        Py_RETURN_NONE;
    for (int field = 0; field < kernel->inputs; ++field) {
        if (!read_field(args[field], kernel->shapes[field], at))
            Py_RETURN_NONE;
        at += count_of(kernel->shapes[field]);
    }
    kernel->one(in, out);
    return new_result(self->result, kernel, out);
}

static PyObject *one_pose_new(PyTypeObject *type, PyObject *args, PyObject *keywords)
{
    const char *name;
    PyTypeObject *result;
    static char *names[] = {"name", "result", NULL};
    if (!PyArg_ParseTupleAndKeywords(args, keywords, "sO!", names, &name, &PyType_Type, &result))
        return NULL;
    for (size_t index = 0; index < count; ++index) {
        if (strcmp(active[index].name, name) != 0)
            continue;
        if (!PyType_IsSubtype(result, &PyTuple_Type))
            break;
        OnePose *self = (OnePose *)type->tp_alloc(type, 0);
        if (!self)
            return NULL;
        Py_INCREF(result);
        self->call = one_pose_call;
        self->index = index;
        self->result = result;
        return (PyObject *)self;
    }
    PyErr_Format(PyExc_ValueError, "no kernel %s that returns a tuple", name);
    return NULL;
}

static void one_pose_dealloc(PyObject *object)
{
    Py_DECREF(((OnePose *)object)->result);
    Py_TYPE(object)->tp_free(object);
}

static PyTypeObject one_pose_type = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "kleinform_kernels.uncoupled._compiled.OnePose",
    .tp_doc = "A kernel on one pose of float64 arrays; None for any other arguments.",
    .tp_basicsize = sizeof(OnePose),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_vectorcall_offset = offsetof(OnePose, call),
    .tp_call = PyVectorcall_Call,
    .tp_new = one_pose_new,
    .tp_dealloc = one_pose_dealloc,
};

/* The module ----------------------------------------------------------------------------- */

static PyObject *module_instructions(PyObject *module, PyObject *Py_UNUSED(none))
{
    (void)module;
    return PyUnicode_FromString(instructions);
}

static PyObject *module_use(PyObject *module, PyObject *name)
{
    (void)module;
    const char *text = PyUnicode_AsUTF8(name);
    if (!text)
        return NULL;
    return PyBool_FromLong(use_named(text));
}

static PyMethodDef methods[] = {
    {"instructions", module_instructions, METH_NOARGS,
     "The instructions in use: baseline, avx2 or avx512."},
    {"use", module_use, METH_O,
     "Use other instructions; False if this machine has not got them."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_compiled",
    .m_doc = "The kernels, compiled.",
    .m_size = -1,
    .m_methods = methods,
};

static int add_checksum(PyObject *module)
{
    PyObject *number = PyLong_FromUnsignedLong(kleinform_table_baseline.checksum);
    const int failed = PyModule_AddObjectRef(module, "CHECKSUM", number);
    Py_XDECREF(number);
    return failed;
}

static int fill(PyObject *module)
{
    if (PyType_Ready(&one_pose_type) < 0 ||
        PyModule_AddObjectRef(module, "OnePose", (PyObject *)&one_pose_type) < 0 ||
        add_checksum(module) < 0)
        return -1;
    memset(types, NPY_DOUBLE, sizeof types);
    for (size_t index = 0; index < count; ++index) {
        PyObject *function = gufunc(index);
        if (!function)
            return -1;
        const int failed = PyModule_AddObjectRef(module, active[index].name, function);
        Py_DECREF(function);
        if (failed < 0)
            return -1;
    }
    return 0;
}

PyMODINIT_FUNC PyInit__compiled(void)
{
    import_array();
    import_umath();
    if (!use_named("avx512") && !use_named("avx2"))
        use_named("baseline");
    for (size_t index = 0; index < count; ++index)
        if (index >= KERNELS || active[index].given > GIVEN || active[index].returned > RETURNED) {
            PyErr_SetString(PyExc_ImportError, "a kernel is larger than its buffers");
            return NULL;
        }
    PyObject *module = PyModule_Create(&definition);
    if (module && fill(module) < 0) {
        Py_DECREF(module);
        return NULL;
    }
    return module;
}
