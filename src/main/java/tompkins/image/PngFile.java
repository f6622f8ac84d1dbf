package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.zip.InflaterInputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataFormatImpl;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Photographs as PNG. The scene is a compressed international text (iTXt) with the keyword {@link #SCENE_KEYWORD}. */
final class PngFile {

    static final String SCENE_KEYWORD = "tompkins.scene";

    /**
     * The byte of a file that holds the bits of a channel: after signature, length and name of the header, width and
     * height.
     */
    static final int BIT_DEPTH_AT = 24;

    private static final String NATIVE = "javax_imageio_png_1.0";

    private PngFile() {}

    static void write(OutputStream out, BufferedImage image, PhotographInfo info) throws IOException {
        ImageWriter writer = ImageProviders.pngWriter();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
            describe(metadata, info);
            writer.setOutput(stream);
            writer.write(new IIOImage(image, null, metadata));
        } finally {
            writer.dispose();
        }
    }

    private static void describe(IIOMetadata metadata, PhotographInfo info) throws IOException {
        IIOMetadataNode text = new IIOMetadataNode("Text");
        addText(text, "Title", info.title());
        addText(text, "Software", info.software());
        if (text.hasChildNodes()) {
            merge(metadata, IIOMetadataFormatImpl.standardMetadataFormatName, text);
        }
        if (!info.sceneJson().isEmpty()) {
            merge(metadata, NATIVE, sceneNode(info.sceneJson()));
        }
    }

    private static void addText(IIOMetadataNode parent, String keyword, String value) {
        if (!value.isEmpty()) {
            IIOMetadataNode entry = new IIOMetadataNode("TextEntry");
            entry.setAttribute("keyword", keyword);
            entry.setAttribute("value", value);
            entry.setAttribute("compression", "none");
            parent.appendChild(entry);
        }
    }

    private static IIOMetadataNode sceneNode(String json) {
        IIOMetadataNode entry = new IIOMetadataNode("iTXtEntry");
        entry.setAttribute("keyword", SCENE_KEYWORD);
        entry.setAttribute("compressionFlag", "TRUE");
        entry.setAttribute("compressionMethod", "0");
        entry.setAttribute("languageTag", "");
        entry.setAttribute("translatedKeyword", "");
        entry.setAttribute("text", json);
        IIOMetadataNode texts = new IIOMetadataNode("iTXt");
        texts.appendChild(entry);
        return texts;
    }

    private static void merge(IIOMetadata metadata, String format, IIOMetadataNode child) throws IOException {
        IIOMetadataNode root = new IIOMetadataNode(format);
        root.appendChild(child);
        metadata.mergeTree(format, root);
    }

    /** The scene in a PNG file, which is read only that far; the JDK is not used, because it cuts texts at 256 kB. */
    static Optional<String> readScene(InputStream file) throws IOException {
        DataInputStream in = new DataInputStream(file);
        long place = PngChunk.skipSignature(in);
        while (true) {
            int length = in.readInt();
            String type = PngChunk.readType(in);
            if (length < 0) {
                throw PngChunk.damaged(place);
            }
            if (type.equals("IEND")) {
                return Optional.empty();
            }
            if (type.equals("iTXt") && length <= PhotographInfo.LONGEST_STORED_SCENE) {
                Optional<String> scene =
                        scene(PngChunk.read(in, type, length, place).data());
                if (scene.isPresent()) {
                    return scene;
                }
            } else {
                in.skipNBytes(length + 4L);
            }
            place += length + PngChunk.FRAME;
        }
    }

    /** The text of an iTXt chunk, if it has our keyword: keyword, 0, compression, method, language, 0, keyword, 0. */
    private static Optional<String> scene(byte[] data) throws IOException {
        ByteArrayInputStream in = new ByteArrayInputStream(data);
        if (!SCENE_KEYWORD.equals(nullTerminated(in))) {
            return Optional.empty();
        }
        boolean compressed = in.read() == 1;
        in.read();
        nullTerminated(in);
        nullTerminated(in);
        try (InputStream text = compressed ? new InflaterInputStream(in) : in) {
            byte[] scene = text.readNBytes(PhotographInfo.LONGEST_STORED_SCENE);
            if (text.read() >= 0) {
                throw new IOException("the scene in it is too long");
            }
            return Optional.of(new String(scene, StandardCharsets.UTF_8));
        }
    }

    private static String nullTerminated(ByteArrayInputStream in) {
        StringBuilder text = new StringBuilder();
        for (int letter = in.read(); letter > 0; letter = in.read()) {
            text.append((char) letter);
        }
        return text.toString();
    }
}
