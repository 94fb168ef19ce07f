// Reads every description of a folder with the package canopen and compares, as read_all.py does: node read_all.js FOLDER
// The package reads formulas as 0, each BOOLEAN as true and integers of 40 to 64 bits as bytes, so these values are not compared.
const fs = require('fs');
const path = require('path');
const { Eds } = require('canopen');

const folder = process.argv[2];
const close = (a, b) => a === b || (typeof a === 'number' && typeof b === 'number' && Math.abs(a - b) <= 1e-6 * Math.abs(a));
const plain = (value) => (typeof value === 'bigint' ? Number(value) : Buffer.isBuffer(value) ? value.toString('hex') : value);

function differences(eds, entries) {
    const found = [];
    for (const [index, sub, type, access, value, isFormula] of entries) {
        const place = index.toString(16) + 'sub' + sub.toString(16);
        try {
            const object = eds.getEntry(index);
            const entry = object._subObjects ? object.at(sub) : object;
            if (type !== null && entry.dataType !== type) found.push(`${place}: type ${entry.dataType} for ${type}`);
            if (access !== null && entry.accessType !== access) found.push(`${place}: access ${entry.accessType} for ${access}`);
            const has = plain(entry.value);
            const isCompared = value !== null && !isFormula && typeof value === 'number' && typeof has === 'number';
            if (isCompared && !close(value, has)) found.push(`${place}: value ${has} for ${value}`);
        } catch (error) {
            found.push(`${place}: ${error.message}`);
        }
    }
    return found;
}

for (const device of JSON.parse(fs.readFileSync(path.join(folder, 'expected.json'), 'utf-8'))) {
    let answer;
    try {
        answer = { differences: differences(Eds.fromFile(path.join(folder, device.file)), device.entries) };
    } catch (error) {
        answer = { refused: error.message };
    }
    console.log(JSON.stringify({ file: device.file, ...answer }));
}
