package tompkins.image;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * Photographs as Radiance pictures (G. Ward, "Real pixels", Graphics Gems II, 1991): three mantissas of 8 bits share
 * one exponent. The scene is written into comments of the header; a long line of the scene takes several comments.
 */
final class RadianceFile {

    private static final String SCENE_LINE = "# tompkins.scene ";
    private static final String SCENE_CONTINUES = "# tompkins.scene+";

    /** Some readers keep a header line in a small buffer. */
    private static final int LONGEST_PIECE = 200;

    private static final int LONGEST_RUN = 127;
    private static final int SHORTEST_RUN = 4;
    private static final int LONGEST_LITERAL = 128;

    private RadianceFile() {}

    /** Whether the format has run lengths for pictures of this width; other rows are written as they are. */
    static boolean isPacked(int width) {
        return width >= 8 && width <= 0x7fff;
    }

    static void write(OutputStream out, LinearImage image, PhotographInfo info) throws IOException {
        out.write(header(image, info).getBytes(StandardCharsets.ISO_8859_1));
        int width = image.width();
        boolean packed = isPacked(width);
        byte[] row = new byte[4 * width];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < width; x++) {
                encode(image.rgb(), 3 * (y * width + x), row, x, packed ? width : 1, packed ? 1 : 4);
            }
            if (packed) {
                writePacked(out, row, width);
            } else {
                out.write(row);
            }
        }
    }

    private static String header(LinearImage image, PhotographInfo info) {
        StringBuilder header = new StringBuilder("#?RADIANCE\n");
        if (!info.title().isEmpty()) {
            header.append("# ").append(AsciiText.escape(info.title())).append('\n');
        }
        if (!info.software().isEmpty()) {
            header.append("SOFTWARE=").append(AsciiText.escape(info.software())).append('\n');
        }
        if (!info.sceneJson().isEmpty()) {
            for (String line : AsciiText.escape(info.sceneJson()).split("\r\n|\r|\n", -1)) {
                appendSceneLine(header, line);
            }
        }
        return header.append("FORMAT=32-bit_rle_rgbe\n\n-Y ")
                .append(image.height())
                .append(" +X ")
                .append(image.width())
                .append('\n')
                .toString();
    }

    private static void appendSceneLine(StringBuilder header, String line) {
        String prefix = SCENE_LINE;
        int from = 0;
        do {
            int to = Math.min(line.length(), from + LONGEST_PIECE);
            header.append(prefix).append(line, from, to).append('\n');
            prefix = SCENE_CONTINUES;
            from = to;
        } while (from < line.length());
    }

    /**
     * Writes one pixel: the exponent e for which the brightest channel is 2^e times a number from 1/2 up to 1, and each
     * channel's whole part of 256 / 2^e times its light. Light below 0 cannot be written and becomes 0.
     */
    private static void encode(float[] rgb, int from, byte[] row, int x, int channelStep, int pixelStep) {
        float red = representable(rgb[from]);
        float green = representable(rgb[from + 1]);
        float blue = representable(rgb[from + 2]);
        float brightest = Math.max(red, Math.max(green, blue));
        // Black, or too dark for the exponents of normal floats: all four bytes are 0.
        boolean dark = brightest < Float.MIN_NORMAL;
        int exponent = dark ? -128 : Math.getExponent(brightest) + 1;
        double scale = dark ? 0 : Math.scalb(1.0, 8 - exponent);
        int at = x * pixelStep;
        row[at] = (byte) (int) (red * scale);
        row[at + channelStep] = (byte) (int) (green * scale);
        row[at + 2 * channelStep] = (byte) (int) (blue * scale);
        row[at + 3 * channelStep] = (byte) (exponent + 128);
    }

    private static float representable(float light) {
        float largest = 255 * 0x1p119f;
        return light > 0 ? Math.min(light, largest) : 0;
    }

    /** A row in four planes, each as runs (128 + length, value) and literals (length, values). */
    private static void writePacked(OutputStream out, byte[] planes, int width) throws IOException {
        out.write(new byte[] {2, 2, (byte) (width >> 8), (byte) width});
        for (int plane = 0; plane < 4; plane++) {
            int at = plane * width;
            int end = at + width;
            while (at < end) {
                int run = runLength(planes, at, end);
                if (run >= SHORTEST_RUN) {
                    out.write(128 + run);
                    out.write(planes[at]);
                    at += run;
                } else {
                    int length = literalLength(planes, at, end);
                    out.write(length);
                    out.write(planes, at, length);
                    at += length;
                }
            }
        }
    }

    private static int runLength(byte[] values, int from, int end) {
        int limit = Math.min(end, from + LONGEST_RUN);
        int to = from + 1;
        while (to < limit && values[to] == values[from]) {
            to++;
        }
        return to - from;
    }

    private static int literalLength(byte[] values, int from, int end) {
        int limit = Math.min(end, from + LONGEST_LITERAL);
        int to = from + 1;
        while (to < limit && runLength(values, to, end) < SHORTEST_RUN) {
            to++;
        }
        return to - from;
    }

    /** The scene in the header, with line ends as line feeds. */
    static Optional<String> readScene(byte[] file) throws IOException {
        StringBuilder scene = new StringBuilder();
        boolean found = false;
        for (String line : RadianceReader.header(new DataInputStream(new ByteArrayInputStream(file)))) {
            if (line.startsWith(SCENE_LINE)) {
                scene.append(found ? "\n" : "").append(line, SCENE_LINE.length(), line.length());
                found = true;
            } else if (line.startsWith(SCENE_CONTINUES)) {
                scene.append(line, SCENE_CONTINUES.length(), line.length());
            }
        }
        return found ? Optional.of(AsciiText.unescape(scene.toString())) : Optional.empty();
    }
}
