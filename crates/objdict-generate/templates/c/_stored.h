/** An image of a storage group has {{ upper }}_..._IMAGE_SIZE bytes: a hash of its layout, the values and a CRC. It is the same for
   every compiler and processor. */
typedef enum {
    {{ upper }}_IMAGE_OK,
    {{ upper }}_IMAGE_LENGTH,   /**< wrong length */
    {{ upper }}_IMAGE_LAYOUT,   /**< from a group with other entries, data types or lengths, or never saved */
    {{ upper }}_IMAGE_CHECKSUM, /**< wrong CRC */
    {{ upper }}_IMAGE_VALUE     /**< a value is not valid for its data type */
} {{ lower }}_image_t;

/* {{ upper }}_..._STORE_SUB_INDEX is the group's sub-index of objects 1010h and 1011h, if known. */
{%- for group in groups %}
#define {{ group.upper }}_IMAGE_SIZE {{ group.group.image_size }}u
{%- if let Some(sub_index) = group.group.sub_index %}
#define {{ group.upper }}_STORE_SUB_INDEX {{ sub_index }}u
{%- endif %}
/** Writes the values of the group to an image for non-volatile memory. */
void {{ group.lower }}_save(const {{ group.lower }}_t *group, uint8_t image[{{ group.upper }}_IMAGE_SIZE]);
/** Reads the values from an image without checking limits; unless it returns {{ upper }}_IMAGE_OK, no value changes. */
{{ lower }}_image_t {{ group.lower }}_load({{ group.lower }}_t *group, const uint8_t *image, size_t length);
{%- endfor %}
