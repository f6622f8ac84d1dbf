package tompkins.image;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.file.FileException;
import tompkins.property.NumberText;

/**
 * Reads Radiance pictures (G. Ward, "Real pixels", Graphics Gems II, 1991, and the Radiance file formats): rows in any
 * of the eight orientations, and with exposures divided out. The library's reader knows only one orientation, and no
 * exposure.
 */
final class RadianceReader {

    private static final Pattern RESOLUTION = Pattern.compile("([-+])([XY]) +(\\d{1,9}) +([-+])([XY]) +(\\d{1,9}) *");
    private static final String RGBE = "32-bit_rle_rgbe";
    private static final String XYZE = "32-bit_rle_xyze";
    private static final int LONGEST_LINE = 1 << 24;
    private static final int LONGEST_QUOTE = 40;

    /** The exponent of a pixel is 128 too large, and its mantissas are 256 times too large. */
    private static final int EXPONENT_BIAS = 136;

    private final DataInputStream in;
    private final String name;

    /** What light was multiplied by before it was written: red, green, blue. */
    private final double[] exposure = {1, 1, 1};

    private final Orientation orientation;
    private final int rows;
    private final byte[] row;

    /** Reads the header. */
    private RadianceReader(InputStream file, String name) throws IOException {
        this.in = new DataInputStream(file);
        this.name = name;
        for (String line : header(in)) {
            readHeaderLine(line);
        }
        String resolution = readLine(in);
        Matcher sides = RESOLUTION.matcher(resolution);
        if (!sides.matches() || sides.group(2).equals(sides.group(5))) {
            throw new FileException(
                    name + ": the size of a Radiance picture must be such as -Y 480 +X 640, was " + quoted(resolution));
        }
        boolean rowsUpright = sides.group(2).equals("X");
        orientation =
                Orientation.of(rowsUpright, isFar(sides.group(1), rowsUpright), isFar(sides.group(4), !rowsUpright));
        rows = Integer.parseInt(sides.group(3));
        int columns = Integer.parseInt(sides.group(6));
        Pixels.requireSize(columns, rows, name);
        row = new byte[4 * columns];
    }

    /** Whether an axis begins at the right or at the bottom: X points to the right and Y up. */
    private static boolean isFar(String sign, boolean isX) {
        return sign.equals("-") == isX;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if they are of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        RadianceReader reader = new RadianceReader(new ByteArrayInputStream(file), name);
        return reader.orientation.turn(reader.readRows());
    }

    /** The lines of the header, up to the empty one at its end. */
    static List<String> header(DataInputStream in) throws IOException {
        List<String> lines = new ArrayList<>();
        for (String line = readLine(in); !line.isEmpty(); line = readLine(in)) {
            lines.add(line);
        }
        return lines;
    }

    private static String readLine(DataInputStream in) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int letter = in.readUnsignedByte(); letter != '\n'; letter = in.readUnsignedByte()) {
            if (line.length() == LONGEST_LINE) {
                throw new IOException("its header has no end");
            }
            line.append((char) letter);
        }
        int end = line.length();
        return line.substring(0, end > 0 && line.charAt(end - 1) == '\r' ? end - 1 : end);
    }

    /**
     * Reads one line; lines of other programs, and those of earlier pictures, which are indented, say nothing about the
     * pixels.
     */
    private void readHeaderLine(String line) throws FileException {
        if (line.startsWith("EXPOSURE=")) {
            double[] factor = factors(line, 1);
            divideBy(factor[0], factor[0], factor[0]);
        } else if (line.startsWith("COLORCORR=")) {
            double[] factor = factors(line, 3);
            divideBy(factor[0], factor[1], factor[2]);
        } else if (line.startsWith("FORMAT=")) {
            requireRgb(value(line));
        }
    }

    private static String value(String line) {
        return line.substring(line.indexOf('=') + 1).strip();
    }

    private void requireRgb(String format) throws FileException {
        if (format.equals(XYZE)) {
            throw new FileException(name + ": its colours are CIE XYZ (" + XYZE + "), not red, green and blue (" + RGBE
                    + "); save it as RGB");
        }
        if (!format.equals(RGBE)) {
            throw new FileException(
                    name + ": the format of a Radiance picture must be " + RGBE + ", was " + quoted(format));
        }
    }

    private double[] factors(String line, int count) throws FileException {
        String[] words = value(line).split("\\s+");
        double[] factors = new double[count];
        boolean allowed = words.length == count;
        for (int i = 0; i < count && allowed; i++) {
            try {
                factors[i] = NumberText.parse(words[i]);
            } catch (NumberFormatException e) {
                factors[i] = Double.NaN;
            }
            allowed = factors[i] > 0 && factors[i] < Double.POSITIVE_INFINITY;
        }
        if (!allowed) {
            throw new FileException(name + ": " + line.substring(0, line.indexOf('='))
                    + " of a Radiance picture must be " + (count == 1 ? "a number" : count + " numbers")
                    + " above 0, was " + quoted(value(line)));
        }
        return factors;
    }

    /** What a header says, for a message: a few letters, and no codes for terminals. */
    private static String quoted(String text) {
        String start = text.length() > LONGEST_QUOTE ? text.substring(0, LONGEST_QUOTE) + "..." : text;
        return start.replaceAll("[^ -~]", "?");
    }

    private void divideBy(double red, double green, double blue) throws FileException {
        exposure[0] *= red;
        exposure[1] *= green;
        exposure[2] *= blue;
        for (double product : exposure) {
            if (!(product > 0 && product < Double.POSITIVE_INFINITY)) {
                throw new FileException(name + ": the exposures of a Radiance picture must have a product above 0"
                        + " that is finite, was " + product);
            }
        }
    }

    private Pixels readRows() throws IOException {
        float[] rgba = new float[row.length * rows];
        for (int y = 0, to = 0; y < rows; y++) {
            readRow();
            for (int from = 0; from < row.length; from += 4, to += 4) {
                putPixel(from, rgba, to);
            }
        }
        return new Pixels(row.length / 4, rows, rgba);
    }

    private void putPixel(int from, float[] rgba, int to) {
        int exponent = row[from + 3] & 0xff;
        double scale = exponent == 0 ? 0 : Math.scalb(1.0, exponent - EXPONENT_BIAS);
        for (int channel = 0; channel < 3; channel++) {
            rgba[to + channel] = (float) ((row[from + channel] & 0xff) * scale / exposure[channel]);
        }
        rgba[to + 3] = 1;
    }

    private void readRow() throws IOException {
        int columns = row.length / 4;
        in.readFully(row, 0, 4);
        boolean planes = RadianceFile.isPacked(columns) && row[0] == 2 && row[1] == 2 && row[2] >= 0;
        if (!planes) {
            in.readFully(row, 4, row.length - 4);
            requireUnpacked();
        } else if (row[2] << 8 != (columns & 0xff00) || row[3] != (byte) columns) {
            throw new IOException("a row has another number of pixels than its header says");
        } else {
            for (int channel = 0; channel < 4; channel++) {
                readPlane(channel);
            }
        }
    }

    /** One channel of a row: runs (128 + length, value) and literals (length, values). */
    private void readPlane(int channel) throws IOException {
        int to = channel;
        while (to < row.length) {
            int code = in.readUnsignedByte();
            int length = code > 128 ? code - 128 : code;
            if (length > (row.length - to + 3) / 4) {
                throw new IOException("a run of pixels is longer than its row");
            }
            byte value = code > 128 ? in.readByte() : 0;
            for (int i = 0; i < length; i++, to += 4) {
                row[to] = code > 128 ? value : in.readByte();
            }
        }
    }

    /** Refuses rows in which (1, 1, 1, n), which no light has, repeats the pixel before n times. */
    private void requireUnpacked() throws FileException {
        for (int at = 0; at < row.length; at += 4) {
            PictureEncoding.HDR.require(
                    row[at] != 1 || row[at + 1] != 1 || row[at + 2] != 1,
                    name,
                    "has runs of whole pixels",
                    "have runs in each channel, or none");
        }
    }
}
