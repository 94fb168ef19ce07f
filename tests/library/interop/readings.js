// What node-canopen reads in descriptions, as readings.py says it of the other tools: a line of JSON for each path on standard input.
const fs = require('fs');
const { Eds } = require('canopen');

const hex = (index) => index.toString(16).toUpperCase();
const REALS = [0x08, 0x11];

/** A value as readings.py shows it. */
function plain(value, type) {
    if (value === undefined || value === null) return null;
    if (Buffer.isBuffer(value)) return value.toString('hex');
    return typeof value === 'string' || REALS.includes(type) ? String(value) : Number(value);
}

function* entries(path) {
    for (const object of Eds.fromFile(path).values()) {
        const subs = object._subObjects ? Object.entries(object._subObjects) : [[0, object]];
        for (const [sub, entry] of subs) {
            const { dataType, accessType, pdoMapping, lowLimit, highLimit } = entry;
            if (dataType === 0x0a) entry._raw = null; // the package takes the digits of an OCTET_STRING for its bytes
            const values = [lowLimit, highLimit, entry._raw && entry.value].map((value) => plain(value, dataType));
            const place = `${hex(object.index).padStart(4, '0')}sub${hex(Number(sub))}`;
            yield [place, [dataType ?? null, accessType ?? null, Number(pdoMapping) === 1, ...values]];
        }
    }
}

function reading(path) {
    try {
        return Object.fromEntries(entries(path));
    } catch (error) {
        return `${error.name}: ${error.message}`;
    }
}

for (const path of fs.readFileSync(0, 'utf-8').split('\n').filter(Boolean)) {
    console.log(JSON.stringify({ path, 'node-canopen': reading(path) }));
}
