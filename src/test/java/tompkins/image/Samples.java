package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriter;
import javax.imageio.spi.IIORegistry;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Pictures, scenes and independent readers for the tests of this package. */
public final class Samples {

    /** Greek letters, letters outside the basic plane, an escape that is none, quotes, and several lines. */
    static final String SCENE =
            "{\n\t\"title\": \"βγ at ½ c, \\\\u03b2 \uD835\uDEFD \\\"fast\\\"\",\n\n  \"camera\": {}\n}\n";

    static final PhotographInfo INFO = new PhotographInfo("Würfel bei β = 0.96", "Tompkins 1.0", SCENE);

    private Samples() {}

    /** More than a million characters, which do not repeat. */
    static String longScene() {
        Random random = new Random(5);
        StringBuilder scene = new StringBuilder("{\"values\": [\"λ\"");
        while (scene.length() < 1_100_000) {
            scene.append(", ")
                    .append(random.nextDouble())
                    .append(", \"ψ")
                    .append(random.nextInt())
                    .append('"');
        }
        return scene.append("]}").toString();
    }

    /** Light from -0.2 to 1.3. */
    static LinearImage random(int width, int height, long seed) {
        Random random = new Random(seed);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat() * 1.5f - 0.2f;
        }
        return new LinearImage(width, height, rgb);
    }

    /** A picture of few colours: squares of light that is 0, 1/2 or 1. */
    static LinearImage squares(int width, int height, int shift) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            int square = (i % width + shift) / 4 + i / width / 4;
            rgb[3 * i] = square % 3 / 2f;
            rgb[3 * i + 1] = square % 2;
            rgb[3 * i + 2] = square / 3 % 2 / 2f;
        }
        return new LinearImage(width, height, rgb);
    }

    /** The JDK's own reader of a format. */
    static ImageReader jdkReader(String format, byte[] file) throws IOException {
        Iterator<ImageReaderSpi> providers =
                IIORegistry.getDefaultInstance().getServiceProviders(ImageReaderSpi.class, true);
        while (providers.hasNext()) {
            ImageReaderSpi provider = providers.next();
            if (provider.getClass().getName().startsWith("com.sun.imageio.plugins." + format)) {
                ImageReader reader = provider.createReaderInstance();
                reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(file)));
                return reader;
            }
        }
        throw new AssertionError("no reader for " + format);
    }

    /** A picture as another program would write it. */
    static byte[] encoded(String format, BufferedImage image) throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName(format);
        ImageWriter writer = writers.next();
        while (!writer.getClass().getName().startsWith("com.sun.")) {
            writer = writers.next();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(out);
            writer.write(image);
        }
        return bytes.toByteArray();
    }

    /** A chunk of a PNG file. */
    record Chunk(String type, byte[] data) {}

    /** The chunks of a PNG file; fails if a check sum is wrong or something follows the last. */
    static List<Chunk> chunks(byte[] png) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(png));
        if (in.readLong() != 0x89504e470d0a1a0aL) {
            throw new AssertionError("no PNG signature");
        }
        List<Chunk> chunks = new ArrayList<>();
        while (in.available() > 0) {
            byte[] typeAndData = new byte[4 + in.readInt()];
            in.readFully(typeAndData, 0, typeAndData.length);
            CRC32 sum = new CRC32();
            sum.update(typeAndData);
            if (in.readInt() != (int) sum.getValue()) {
                throw new AssertionError("wrong check sum");
            }
            byte[] data = new byte[typeAndData.length - 4];
            System.arraycopy(typeAndData, 4, data, 0, data.length);
            chunks.add(new Chunk(new String(typeAndData, 0, 4, StandardCharsets.US_ASCII), data));
        }
        return chunks;
    }

    /** The chunks of one type. */
    static List<byte[]> chunks(byte[] png, String type) throws IOException {
        return chunks(png).stream()
                .filter(chunk -> chunk.type().equals(type))
                .map(Chunk::data)
                .toList();
    }

    /** The names of everything in a folder, sorted. */
    public static List<String> names(Path folder) throws IOException {
        try (Stream<Path> content = Files.list(folder)) {
            return content.map(path -> path.getFileName().toString()).sorted().toList();
        }
    }

    /** The file with some of its bytes changed, removed, doubled, or its end cut off. */
    static byte[] damaged(byte[] file, Random random) {
        byte[] result = file.clone();
        int at = random.nextInt(file.length);
        switch (random.nextInt(4)) {
            case 0 -> {
                for (int i = 0; i <= random.nextInt(4); i++) {
                    result[random.nextInt(file.length)] = (byte) random.nextInt();
                }
            }
            case 1 -> result = java.util.Arrays.copyOf(file, at);
            case 2 -> {
                // Near the beginning, where sizes and offsets are.
                result[random.nextInt(Math.min(64, file.length))] ^= (byte) (1 << random.nextInt(8));
            }
            default -> {
                int length = Math.min(random.nextInt(8), file.length - at);
                result = new byte[file.length - length];
                System.arraycopy(file, 0, result, 0, at);
                System.arraycopy(file, at + length, result, at, file.length - at - length);
            }
        }
        return result;
    }

    /** A picture as a screen shows it, with even levels. */
    static BufferedImage levels(LinearImage image) {
        return BufferedImages.toBufferedImage(image, ToneCurve.LINEAR);
    }
}
