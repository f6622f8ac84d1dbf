package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataFormatImpl;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import tompkins.property.OneLine;

/** Photographs as PNG. The scene is a compressed international text (iTXt) with the keyword {@link #SCENE_KEYWORD}. */
final class PngFile {

    static final String SCENE_KEYWORD = "tompkins.scene";

    /** The byte of a file that holds the bits of a channel, behind width and height. */
    static final int BIT_DEPTH_AT = 24;

    private static final String TITLE_KEYWORD = "Title";
    private static final String SOFTWARE_KEYWORD = "Software";
    private static final String DESCRIPTION_KEYWORD = "Description";

    /** The indicator of a stereo pair (Extensions to the PNG Specification, sTER): one byte says which eye is where. */
    private static final String STEREO_CHUNK = "sTER";

    private static final byte LEFT_EYE_ON_THE_LEFT = 1;

    /** The right picture must begin at a column that is a multiple of this. */
    private static final int STEREO_STEP = 8;

    private static final String NATIVE = "javax_imageio_png_1.0";

    private PngFile() {}

    static void write(OutputStream out, BufferedImage image, PhotographInfo info) throws IOException {
        ImageWriter writer = ImageProviders.writer(PictureEncoding.PNG);
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
            describe(metadata, info, image);
            writer.setOutput(stream);
            writer.write(new IIOImage(image, null, metadata));
        } finally {
            writer.dispose();
        }
    }

    private static void describe(IIOMetadata metadata, PhotographInfo info, BufferedImage image) throws IOException {
        IIOMetadataNode text = new IIOMetadataNode("Text");
        addText(text, TITLE_KEYWORD, info.title());
        addText(text, SOFTWARE_KEYWORD, info.software());
        addText(text, DESCRIPTION_KEYWORD, info.description());
        if (text.hasChildNodes()) {
            merge(metadata, IIOMetadataFormatImpl.standardMetadataFormatName, text);
        }
        if (!info.sceneJson().isEmpty()) {
            merge(metadata, NATIVE, textNode(SCENE_KEYWORD, info.sceneJson(), true));
        }
        if (info.panorama().isPresent()) {
            // where viewers look for it, it must not be compressed
            String xmp = info.panorama().get().xmp(image.getWidth(), image.getHeight());
            merge(metadata, NATIVE, textNode(Panorama.KEYWORD, xmp, false));
        }
        if (info.stereoPair() && image.getWidth() % (2 * STEREO_STEP) == 0) {
            merge(metadata, NATIVE, stereoNode());
        }
    }

    private static IIOMetadataNode stereoNode() {
        IIOMetadataNode chunk = new IIOMetadataNode("UnknownChunk");
        chunk.setAttribute("type", STEREO_CHUNK);
        chunk.setUserObject(new byte[] {LEFT_EYE_ON_THE_LEFT});
        IIOMetadataNode chunks = new IIOMetadataNode("UnknownChunks");
        chunks.appendChild(chunk);
        return chunks;
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

    private static IIOMetadataNode textNode(String keyword, String text, boolean compressed) {
        IIOMetadataNode entry = new IIOMetadataNode("iTXtEntry");
        entry.setAttribute("keyword", keyword);
        entry.setAttribute("compressionFlag", compressed ? "TRUE" : "FALSE");
        entry.setAttribute("compressionMethod", "0");
        entry.setAttribute("languageTag", "");
        entry.setAttribute("translatedKeyword", "");
        entry.setAttribute("text", text);
        IIOMetadataNode texts = new IIOMetadataNode("iTXt");
        texts.appendChild(entry);
        return texts;
    }

    private static void merge(IIOMetadata metadata, String format, IIOMetadataNode child) throws IOException {
        IIOMetadataNode root = new IIOMetadataNode(format);
        root.appendChild(child);
        metadata.mergeTree(format, root);
    }

    /** The scene in a PNG file, which is read only that far. */
    static Optional<String> readScene(byte[] png) throws IOException {
        return Optional.ofNullable(readTexts(png, Set.of(SCENE_KEYWORD), "IEND").get(SCENE_KEYWORD));
    }

    /** The scene and the description in a PNG file, which is read up to its pixels; empty where it has none. */
    static PhotographInfo readInfo(byte[] png) throws IOException {
        Map<String, String> texts = readTexts(png, Set.of(SCENE_KEYWORD, DESCRIPTION_KEYWORD), "IDAT");
        return new PhotographInfo("", "", texts.getOrDefault(SCENE_KEYWORD, ""))
                .withDescription(OneLine.of(texts.getOrDefault(DESCRIPTION_KEYWORD, "")));
    }

    /**
     * The texts with some keywords, read until all are found or a chunk of the last type comes; the JDK is not used,
     * because it cuts texts at 256 kB.
     */
    private static Map<String, String> readTexts(byte[] png, Set<String> keywords, String lastType) throws IOException {
        Map<String, String> texts = new HashMap<>();
        int place = PngChunk.SIGNATURE.length;
        while (!texts.keySet().equals(keywords)) {
            PngChunk chunk = PngChunk.at(png, place);
            if (chunk.type().equals(lastType)) {
                break;
            }
            if (chunk.type().equals("iTXt") || chunk.type().equals("tEXt")) {
                ByteArrayInputStream text = new ByteArrayInputStream(chunk.data());
                String keyword = nullTerminated(text);
                if (keywords.contains(keyword) && !texts.containsKey(keyword)) {
                    texts.put(
                            keyword,
                            chunk.type().equals("iTXt")
                                    ? international(text)
                                    : new String(text.readAllBytes(), StandardCharsets.ISO_8859_1));
                }
            }
            place += chunk.size();
        }
        return texts;
    }

    /** The text of an iTXt chunk behind its keyword: compression, method, language, 0, translated keyword, 0, text. */
    private static String international(ByteArrayInputStream in) throws IOException {
        boolean compressed = in.read() == 1;
        in.read();
        nullTerminated(in);
        nullTerminated(in);
        Inflater inflater = new Inflater();
        try (InputStream text = compressed ? new InflaterInputStream(in, inflater) : in) {
            byte[] letters = text.readNBytes(PhotographInfo.LONGEST_STORED_SCENE);
            if (text.read() >= 0) {
                throw new IOException("the scene in it is too long");
            }
            if (inflater.needsDictionary()) {
                throw new IOException("the scene in it is packed with a preset dictionary, which PNG does not allow");
            }
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(letters))
                    .toString();
        } catch (CharacterCodingException wrong) {
            throw new IOException("the scene in it is not text in the encoding UTF-8");
        } finally {
            inflater.end();
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
