package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import javax.imageio.plugins.tiff.TIFFTag;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Photographs as TIFF. The scene is the image description (tag 270), in ASCII as the tag demands. */
final class TiffFile {

    private TiffFile() {}

    static void write(OutputStream out, BufferedImage image, PhotographInfo info) throws IOException {
        ImageWriter writer = ImageProviders.writer(PictureEncoding.TIFF);
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            ImageWriteParam compression = writer.getDefaultWriteParam();
            compression.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            compression.setCompressionType("ZLib");
            // the lowest level: the highest takes seconds, and saves a tenth of the bytes at most
            compression.setCompressionQuality(0);
            TIFFDirectory directory = TIFFDirectory.createFromMetadata(
                    writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), compression));
            addText(directory, BaselineTIFFTagSet.TAG_DOCUMENT_NAME, info.title());
            addText(directory, BaselineTIFFTagSet.TAG_SOFTWARE, info.software());
            addText(directory, BaselineTIFFTagSet.TAG_IMAGE_DESCRIPTION, info.sceneJson());
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, directory.getAsMetadata()), compression);
        } finally {
            writer.dispose();
        }
    }

    private static void addText(TIFFDirectory directory, int number, String text) {
        if (!text.isEmpty()) {
            TIFFTag tag = BaselineTIFFTagSet.getInstance().getTag(number);
            String[] value = {AsciiText.escape(text)};
            directory.addTIFFField(new TIFFField(tag, TIFFTag.TIFF_ASCII, 1, value));
        }
    }

    /** Whether the channels are stored as floating point. */
    static boolean isFloatingPoint(byte[] file) throws IOException {
        return TiffDirectory.read(file).number(TIFF.TAG_SAMPLE_FORMAT, 0)
                == BaselineTIFFTagSet.SAMPLE_FORMAT_FLOATING_POINT;
    }

    /**
     * The image description, if it is a JSON object; other programs put other things there. The JDK is not used,
     * because it cuts texts at 64 kB.
     */
    static Optional<String> readScene(byte[] file) throws IOException {
        return TiffDirectory.read(file).value(TIFF.TAG_IMAGE_DESCRIPTION) instanceof String text
                        && text.stripLeading().startsWith("{")
                ? Optional.of(AsciiText.unescape(text))
                : Optional.empty();
    }
}
