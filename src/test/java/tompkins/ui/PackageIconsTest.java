package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The icons of the packages are drawn by the program; {@code -Dtompkins.regenerate=true} writes them. */
class PackageIconsTest {

    private static final Path FOLDER = Path.of(System.getProperty("basedir", ""), "src", "package");

    /**
     * Sizes in the file for Windows. The largest is a PNG, as its menus expect; the others are bitmaps, which
     * everything there reads.
     */
    private static final List<Integer> SIZES_OF_WINDOWS = List.of(16, 24, 32, 48, 64, 256);

    /** Sizes in the file for macOS, with the names that stand for them there. */
    private static final Map<String, Integer> SIZES_OF_MAC =
            new TreeMap<>(Map.of("ic11", 32, "ic12", 64, "ic07", 128, "ic08", 256, "ic09", 512));

    /** Largest difference of a channel: another Java machine may round otherwise where a line is smoothed. */
    private static final int ROUNDING = 8;

    private static final int PNG_SIZE = 256;
    private static final int SIZE_OF_LINUX = 128;
    private static final int BITMAP_HEADER = 40;
    private static final int ENTRY = 16;

    @BeforeAll
    static void write() throws IOException {
        if (Boolean.getBoolean("tompkins.regenerate")) {
            Files.write(FOLDER.resolve("tompkins.png"), png(SIZE_OF_LINUX));
            Files.write(FOLDER.resolve("tompkins.ico"), icoFile());
            Files.write(FOLDER.resolve("tompkins.icns"), icnsFile());
        }
    }

    @Test
    void linuxHasTheSign() throws IOException {
        assertSign(ImageIO.read(FOLDER.resolve("tompkins.png").toFile()), SIZE_OF_LINUX);
    }

    @Test
    void windowsHasTheSignInAllSizes() throws IOException {
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(FOLDER.resolve("tompkins.ico")))
                .order(ByteOrder.LITTLE_ENDIAN);
        assertThat(file.getInt()).as("an icon").isEqualTo(0x10000);
        List<Integer> sizes = new ArrayList<>();
        int count = file.getShort();
        for (int i = 0; i < count; i++) {
            int size = Byte.toUnsignedInt(file.get());
            size = size == 0 ? PNG_SIZE : size;
            sizes.add(size);
            file.position(file.position() + 7);
            byte[] data = new byte[file.getInt()];
            file.get(file.getInt(), data);
            assertSign(size == PNG_SIZE ? ImageIO.read(new ByteArrayInputStream(data)) : bitmap(data, size), size);
        }
        assertThat(sizes).isEqualTo(SIZES_OF_WINDOWS);
    }

    @Test
    void macHasTheSignInAllSizes() throws IOException {
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(FOLDER.resolve("tompkins.icns")));
        assertThat(name(file)).isEqualTo("icns");
        assertThat(file.getInt()).as("length").isEqualTo(file.capacity());
        Map<String, Integer> sizes = new TreeMap<>();
        while (file.hasRemaining()) {
            String name = name(file);
            byte[] data = new byte[file.getInt() - 8];
            file.get(data);
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(data));
            sizes.put(name, image.getWidth());
            assertSign(image, image.getWidth());
        }
        assertThat(sizes).isEqualTo(SIZES_OF_MAC);
    }

    private static void assertSign(BufferedImage image, int size) {
        assertThat(image.getWidth()).isEqualTo(size);
        assertThat(image.getHeight()).isEqualTo(size);
        BufferedImage drawn = WindowIcon.image(size);
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                    int expected = drawn.getRGB(x, y) >>> shift & 0xff;
                    if (Math.abs((image.getRGB(x, y) >>> shift & 0xff) - expected) > ROUNDING) {
                        throw new AssertionError("pixel " + x + ", " + y + " of size " + size);
                    }
                }
            }
        }
    }

    /** Reads a bitmap without compression, whose rows begin at the bottom. */
    private static BufferedImage bitmap(byte[] data, int size) {
        ByteBuffer bitmap = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(List.of(bitmap.getInt(), bitmap.getInt(), bitmap.getInt(), bitmap.getInt()))
                .as("header, width, heights of picture and mask, planes and depth")
                .containsExactly(BITMAP_HEADER, size, 2 * size, 0x200001);
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        bitmap.position(BITMAP_HEADER);
        for (int y = size - 1; y >= 0; y--) {
            for (int x = 0; x < size; x++) {
                image.setRGB(x, y, bitmap.getInt());
            }
        }
        assertThat(bitmap.remaining()).as("mask").isEqualTo(maskBytes(size));
        return image;
    }

    private static String name(ByteBuffer file) {
        byte[] name = new byte[4];
        file.get(name);
        return new String(name, StandardCharsets.US_ASCII);
    }

    private static byte[] png(int size) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(WindowIcon.image(size), "png", out);
        return out.toByteArray();
    }

    /** One bit a pixel in rows of whole words; nothing is set, since the pixels have their own transparency. */
    private static int maskBytes(int size) {
        return (size + 31) / 32 * 4 * size;
    }

    private static byte[] bitmap(int size) {
        ByteBuffer out = ByteBuffer.allocate(BITMAP_HEADER + 4 * size * size + maskBytes(size))
                .order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(BITMAP_HEADER).putInt(size).putInt(2 * size).putInt(0x200001);
        out.position(BITMAP_HEADER);
        BufferedImage image = WindowIcon.image(size);
        for (int y = size - 1; y >= 0; y--) {
            for (int x = 0; x < size; x++) {
                out.putInt(image.getRGB(x, y));
            }
        }
        return out.array();
    }

    private static byte[] icoFile() throws IOException {
        ByteArrayOutputStream pictures = new ByteArrayOutputStream();
        ByteBuffer head =
                ByteBuffer.allocate(6 + ENTRY * SIZES_OF_WINDOWS.size()).order(ByteOrder.LITTLE_ENDIAN);
        head.putInt(0x10000).putShort((short) SIZES_OF_WINDOWS.size());
        for (int size : SIZES_OF_WINDOWS) {
            byte[] picture = size == PNG_SIZE ? png(size) : bitmap(size);
            // one plane of 32 bits; a size of 256 is written as 0
            head.put((byte) size).put((byte) size).putShort((short) 0).putInt(0x200001);
            head.putInt(picture.length).putInt(head.capacity() + pictures.size());
            pictures.writeBytes(picture);
        }
        return concatenated(head.array(), pictures);
    }

    private static byte[] icnsFile() throws IOException {
        ByteArrayOutputStream pictures = new ByteArrayOutputStream();
        for (Map.Entry<String, Integer> size : SIZES_OF_MAC.entrySet()) {
            byte[] picture = png(size.getValue());
            pictures.writeBytes(head(size.getKey(), picture.length));
            pictures.writeBytes(picture);
        }
        return concatenated(head("icns", pictures.size()), pictures);
    }

    /** A name and the length of what it names, itself included. */
    private static byte[] head(String name, int length) {
        return ByteBuffer.allocate(8)
                .put(name.getBytes(StandardCharsets.US_ASCII))
                .putInt(8 + length)
                .array();
    }

    private static byte[] concatenated(byte[] head, ByteArrayOutputStream rest) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(head);
        out.writeBytes(rest.toByteArray());
        return out.toByteArray();
    }
}
