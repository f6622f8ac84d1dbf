package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import tompkins.file.PendingFile;

/** An animated GIF that plays forever; each frame has its own palette. */
final class GifWriter extends AnimationWriter {

    private static final String NATIVE = "javax_imageio_gif_image_1.0";

    /** Delays are hundredths of a second, and browsers take those below two for mistakes and play slowly. */
    static final int FASTEST = 50;

    private final int framesPerSecond;
    private final OutputStream out;
    private final ImageOutputStream stream;
    private final ImageWriter writer;

    GifWriter(PendingFile pending, int framesPerSecond) throws IOException {
        super(pending);
        this.framesPerSecond = framesPerSecond;
        this.writer = ImageProviders.writer(PictureEncoding.GIF);
        this.out = pending.open();
        this.stream = new MemoryCacheImageOutputStream(out);
    }

    @Override
    void write(BufferedImage picture, int index) throws IOException {
        if (index == 0) {
            writer.setOutput(stream);
            writer.prepareWriteSequence(null);
        }
        BufferedImage frame = Palette.reduced(picture);
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(frame), null);
        IIOMetadataNode root = new IIOMetadataNode(NATIVE);
        root.appendChild(delayNode(index));
        if (index == 0) {
            root.appendChild(loopNode());
        }
        metadata.mergeTree(NATIVE, root);
        ImageWriteParam rowAfterRow = writer.getDefaultWriteParam();
        rowAfterRow.setProgressiveMode(ImageWriteParam.MODE_DISABLED);
        writer.writeToSequence(new IIOImage(frame, null, metadata), rowAfterRow);
        stream.flush();
    }

    /** Whole hundredths of a second whose sum keeps up with the time. */
    private IIOMetadataNode delayNode(int index) {
        long delay = Math.round(100.0 * (index + 1) / framesPerSecond) - Math.round(100.0 * index / framesPerSecond);
        IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
        control.setAttribute("disposalMethod", "none");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "FALSE");
        control.setAttribute("transparentColorIndex", "0");
        control.setAttribute("delayTime", Long.toString(delay));
        return control;
    }

    private static IIOMetadataNode loopNode() {
        IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
        loop.setAttribute("applicationID", "NETSCAPE");
        loop.setAttribute("authenticationCode", "2.0");
        loop.setUserObject(new byte[] {1, 0, 0});
        IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
        extensions.appendChild(loop);
        return extensions;
    }

    @Override
    void complete() throws IOException {
        writer.endWriteSequence();
        writer.dispose();
        try (out) {
            stream.close();
        }
    }
}
