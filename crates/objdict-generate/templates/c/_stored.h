/* An image of a storage group is {{ upper }}_..._IMAGE_SIZE bytes: a hash of what it holds, the values and a CRC. It is the same with
   every compiler and processor. */
typedef enum {
    {{ upper }}_IMAGE_OK,
    {{ upper }}_IMAGE_LENGTH,   /* it is shorter or longer */
    {{ upper }}_IMAGE_LAYOUT,   /* it is of a group with other entries, data types or lengths, or was never saved */
    {{ upper }}_IMAGE_CHECKSUM, /* its CRC does not fit */
    {{ upper }}_IMAGE_VALUE     /* a value is none of its data type */
} {{ lower }}_image_t;

/* ..._save() puts the values of a group into an image, as memory shall keep it. ..._load() takes them from an image, whatever the
   limits; unless it answers {{ upper }}_IMAGE_OK, no value changed. {{ upper }}_..._STORE_SUB_INDEX is the sub-index of objects 1010h and 1011h
   that is about the group, where that is known. */
{%- for group in groups %}
#define {{ group.upper }}_IMAGE_SIZE {{ group.group.image_size }}u
{%- if let Some(sub_index) = group.group.sub_index %}
#define {{ group.upper }}_STORE_SUB_INDEX {{ sub_index }}u
{%- endif %}
void {{ group.lower }}_save(const {{ group.lower }}_t *group, uint8_t image[{{ group.upper }}_IMAGE_SIZE]);
{{ lower }}_image_t {{ group.lower }}_load({{ group.lower }}_t *group, const uint8_t *image, size_t length);
{%- endfor %}
