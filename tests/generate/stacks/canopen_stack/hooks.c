/*
 * Types of an application: the lowest byte of what is read is 5Ah, and what begins with FFh is refused. DICTIONARY names the
 * header of the dictionary.
 */
#include DICTIONARY

static CO_ERR marked(CO_ERR error, void *buffer, uint32_t size)
{
    if (error == CO_ERR_NONE && size > 0u) {
        *(uint8_t *)buffer = 0x5Au;
    }
    return error;
}

static uint32_t number_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{
    return (CO_TSIGNED16)->Size(obj, node, width);
}

static CO_ERR number_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    return marked((CO_TSIGNED16)->Read(obj, node, buffer, size), buffer, size);
}

static CO_ERR number_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    return *(uint8_t *)buffer == 0xFFu ? CO_ERR_OBJ_RANGE : (CO_TSIGNED16)->Write(obj, node, buffer, size);
}

const CO_OBJ_TYPE od_hook2101 = {number_size, NULL, number_read, number_write, NULL};
const CO_OBJ_TYPE od_hook2102 = {number_size, NULL, number_read, number_write, NULL};

static uint32_t text_size(struct CO_OBJ_T *obj, struct CO_NODE_T *node, uint32_t width)
{
    return od_bytes.Size(obj, node, width);
}

static CO_ERR text_read(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    return marked(od_bytes.Read(obj, node, buffer, size), buffer, size);
}

static CO_ERR text_write(struct CO_OBJ_T *obj, struct CO_NODE_T *node, void *buffer, uint32_t size)
{
    return od_bytes.Write(obj, node, buffer, size);
}

const CO_OBJ_TYPE od_hook2103 = {text_size, NULL, text_read, text_write, NULL};
