package tompkins.image;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.zip.DeflaterOutputStream;

/** Writes TIFF files of every kind, from TIFF 6.0 alone. */
final class TiffSample {

    static final int NONE = 1;
    static final int LZW = 5;
    static final int DEFLATE = 8;
    static final int PACK_BITS = 32773;

    /** What a pixel holds: the whole number of each sample. */
    interface Codes {
        long at(int x, int y, int sample);
    }

    private final int width;
    private final int height;
    private final int[] bits;
    private final Codes codes;
    private final TreeMap<Integer, long[]> tags = new TreeMap<>();
    private ByteOrder order = ByteOrder.LITTLE_ENDIAN;
    private boolean planar;
    private int compression = NONE;
    private int predictor = 1;
    private int stripWidth;
    private int stripHeight;
    private boolean tiled;
    private boolean bitsReversed;

    /** Strips of all rows, little endian, not packed. */
    TiffSample(int width, int height, int photometric, int[] bits, Codes codes) {
        this.width = width;
        this.height = height;
        this.bits = bits;
        this.codes = codes;
        stripWidth = width;
        stripHeight = height;
        tag(256, width).tag(257, height).tag(262, photometric).tag(277, bits.length);
        tag(258, IntStream.of(bits).asLongStream().toArray());
    }

    /** Of equal bits. */
    static int[] bits(int samples, int bits) {
        return IntStream.generate(() -> bits).limit(samples).toArray();
    }

    TiffSample tag(int number, long... values) {
        tags.put(number, values);
        return this;
    }

    TiffSample order(ByteOrder newOrder) {
        order = newOrder;
        return this;
    }

    TiffSample planar() {
        planar = true;
        return tag(284, 2);
    }

    TiffSample compression(int number, int newPredictor) {
        compression = number;
        predictor = newPredictor;
        return tag(259, number).tag(317, newPredictor);
    }

    TiffSample strips(int rows) {
        stripHeight = rows;
        return tag(278, rows);
    }

    TiffSample tiles(int columns, int rows) {
        tiled = true;
        stripWidth = columns;
        stripHeight = rows;
        return tag(322, columns).tag(323, rows);
    }

    TiffSample bitsReversed() {
        bitsReversed = true;
        return tag(266, 2);
    }

    byte[] bytes() {
        List<byte[]> strips = new ArrayList<>();
        int perPlane = planar ? 1 : bits.length;
        for (int first = 0; first < bits.length; first += perPlane) {
            for (int y = 0; y < height; y += stripHeight) {
                for (int x = 0; x < width; x += stripWidth) {
                    strips.add(strip(x, y, first, perPlane));
                }
            }
        }
        long[] lengths = strips.stream().mapToLong(strip -> strip.length).toArray();
        tag(tiled ? 325 : 279, lengths);
        long[] offsets = new long[lengths.length];
        tag(tiled ? 324 : 273, offsets);
        int size = 8 + 2 + 12 * tags.size() + 4;
        int at = size;
        for (var tag : tags.entrySet()) {
            int length = sizeOf(tag.getKey()) * tag.getValue().length;
            at += length > 4 ? length : 0;
        }
        for (int i = 0; i < offsets.length; i++) {
            offsets[i] = at;
            at += (int) lengths[i];
        }
        ByteBuffer file = ByteBuffer.allocate(at).order(order);
        file.put((byte) (order == ByteOrder.LITTLE_ENDIAN ? 'I' : 'M'))
                .put(file.get(0))
                .putShort((short) 42)
                .putInt(8);
        file.putShort((short) tags.size());
        int further = size;
        for (var tag : tags.entrySet()) {
            long[] values = tag.getValue();
            boolean inside = sizeOf(tag.getKey()) * values.length <= 4;
            file.putShort(tag.getKey().shortValue()).putShort((short) typeOf(tag.getKey()));
            file.putInt(values.length).putInt(inside ? 0 : further);
            int to = inside ? file.position() - 4 : further;
            for (int i = 0; i < values.length; i++, to += sizeOf(tag.getKey())) {
                if (sizeOf(tag.getKey()) == 2) {
                    file.putShort(to, (short) values[i]);
                } else {
                    file.putInt(to, (int) values[i]);
                }
            }
            further = inside ? further : to;
        }
        file.putInt(0).position(further);
        strips.forEach(file::put);
        return file.array();
    }

    private static int typeOf(int tag) {
        return sizeOf(tag) == 2 ? 3 : 4;
    }

    /** Sizes and places in the file have four bytes, all else two. */
    private static int sizeOf(int tag) {
        return switch (tag) {
            case 256, 257, 273, 278, 279, 322, 323, 324, 325 -> 4;
            default -> 2;
        };
    }

    private byte[] strip(int left, int top, int first, int perPlane) {
        ByteArrayOutputStream rows = new ByteArrayOutputStream();
        int end = tiled ? top + stripHeight : Math.min(height, top + stripHeight);
        for (int y = top; y < end; y++) {
            StringBuilder row = new StringBuilder();
            for (int x = left; x < left + stripWidth; x++) {
                for (int sample = first; sample < first + perPlane; sample++) {
                    appendBits(row, stored(x, y, left, sample), bits[sample]);
                }
            }
            while (row.length() % 8 > 0) {
                row.append('1');
            }
            for (int i = 0; i < row.length(); i += 8) {
                int value = Integer.parseInt(row.substring(i, i + 8), 2);
                rows.write(bitsReversed ? Integer.reverse(value) >>> 24 : value);
            }
        }
        return packed(rows.toByteArray());
    }

    private long stored(int x, int y, int left, int sample) {
        long code = inside(x, y, sample);
        long before = predictor == 2 && x > left ? inside(x - 1, y, sample) : 0;
        return code - before & (bits[sample] == 64 ? -1 : (1L << bits[sample]) - 1);
    }

    /** Tiles go on beyond the picture. */
    private long inside(int x, int y, int sample) {
        return codes.at(Math.min(x, width - 1), Math.min(y, height - 1), sample);
    }

    /** Whole pairs, threes and fours of bytes lie in the order of the file, other bits from the highest on. */
    private void appendBits(StringBuilder row, long code, int count) {
        boolean swapped = count % 8 == 0 && order == ByteOrder.LITTLE_ENDIAN;
        for (int i = 0; i < count; i++) {
            int bit = swapped ? i / 8 * 8 + 7 - i % 8 : count - 1 - i;
            row.append(code >> bit & 1);
        }
    }

    private byte[] packed(byte[] plain) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        switch (compression) {
            case DEFLATE -> {
                try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
                    deflater.write(plain);
                } catch (java.io.IOException e) {
                    throw new AssertionError(e);
                }
            }
            case PACK_BITS -> {
                for (int i = 0; i < plain.length; i += 100) {
                    int length = Math.min(100, plain.length - i);
                    out.write(length - 1);
                    out.write(plain, i, length);
                }
            }
            case LZW -> {
                // Codes of 9 bits, cleared before they would need more.
                StringBuilder stream = new StringBuilder();
                for (int i = 0; i < plain.length; i++) {
                    if (i % 200 == 0) {
                        appendBits(stream, 256, 9);
                    }
                    appendBits(stream, plain[i] & 0xff, 9);
                }
                appendBits(stream, 257, 9);
                stream.append("0".repeat((8 - stream.length() % 8) % 8));
                for (int i = 0; i < stream.length(); i += 8) {
                    out.write(Integer.parseInt(stream.substring(i, i + 8), 2));
                }
            }
            default -> out.writeBytes(plain);
        }
        return out.toByteArray();
    }
}
