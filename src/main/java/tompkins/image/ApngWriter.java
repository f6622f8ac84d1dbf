package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import tompkins.file.PendingFile;

/**
 * An animated PNG (PNG specification, third edition, section 11.3.6): the chunks of ordinary PNG pictures, with the
 * data of all but the first renamed, and a frame control before each. The number of frames stands near the beginning
 * and is filled in at the end.
 */
final class ApngWriter extends AnimationWriter {

    private static final int FOR_EVER = 0;

    private final SeekableByteChannel channel;
    private final OutputStream out;
    private final int framesPerSecond;
    private long animationControlAt;
    private int sequenceNumber;

    ApngWriter(PendingFile pending, int framesPerSecond) throws IOException {
        super(pending);
        this.framesPerSecond = framesPerSecond;
        this.channel = pending.openChannel();
        this.out = new BufferedOutputStream(Channels.newOutputStream(channel), 1 << 16);
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        boolean first = index == 0;
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        PngFile.write(png, frame, first ? info : PhotographInfo.NONE);
        if (first) {
            PngChunk.writeSignature(out);
        }
        boolean controlled = false;
        for (PngChunk chunk : PngChunk.all(png.toByteArray())) {
            boolean data = chunk.type().equals("IDAT");
            if (data && !controlled) {
                if (first) {
                    out.flush();
                    animationControlAt = channel.position();
                    animationControl(0).write(out);
                }
                frameControl(frame).write(out);
                controlled = true;
            }
            if (data && !first) {
                frameData(chunk).write(out);
            } else if (first && !chunk.type().equals("IEND")) {
                chunk.write(out);
            }
        }
    }

    private static PngChunk animationControl(int frames) {
        return new PngChunk(
                "acTL", ByteBuffer.allocate(8).putInt(frames).putInt(FOR_EVER).array());
    }

    private PngChunk frameControl(BufferedImage frame) {
        ByteBuffer control = ByteBuffer.allocate(26);
        control.putInt(sequenceNumber++);
        control.putInt(frame.getWidth()).putInt(frame.getHeight());
        control.putInt(0).putInt(0);
        control.putShort((short) 1).putShort((short) framesPerSecond);
        // The last two bytes stay 0: leave the frame as it is, and replace what is there.
        return new PngChunk("fcTL", control.array());
    }

    private PngChunk frameData(PngChunk data) {
        ByteBuffer numbered = ByteBuffer.allocate(4 + data.data().length);
        numbered.putInt(sequenceNumber++).put(data.data());
        return new PngChunk("fdAT", numbered.array());
    }

    @Override
    void complete(int frames) throws IOException {
        new PngChunk("IEND", new byte[0]).write(out);
        out.flush();
        channel.position(animationControlAt);
        animationControl(frames).write(out);
        out.close();
    }
}
