package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.PendingFile;

/** H.264 video, made by feeding the pixels to the program ffmpeg. What it complains about becomes the message. */
final class Mp4Writer extends AnimationWriter {

    private final Path program;
    private final int framesPerSecond;
    private Process process;
    private CompletableFuture<String> complaints;

    Mp4Writer(Path program, PendingFile pending, int framesPerSecond) {
        super(pending);
        this.program = program;
        this.framesPerSecond = framesPerSecond;
    }

    /** The program ffmpeg in the folders of a path; refused if it is in none. */
    static Path program(String path) throws FileException {
        return Pattern.compile(Pattern.quote(File.pathSeparator))
                .splitAsStream(path)
                .flatMap(folder -> Stream.of(new File(folder, "ffmpeg"), new File(folder, "ffmpeg.exe")))
                .filter(file -> file.isFile() && file.canExecute())
                .map(File::toPath)
                .findFirst()
                .orElseThrow(() -> new FileException("ffmpeg: not found on the path; install it to save MP4 videos,"
                        + " or save an animated GIF or numbered pictures"));
    }

    @Override
    void write(BufferedImage frame, int index) throws IOException {
        int[] colours = frame.getRGB(0, 0, frame.getWidth(), frame.getHeight(), null, 0, frame.getWidth());
        if (index == 0) {
            start(frame.getWidth() + "x" + frame.getHeight());
        }
        ByteBuffer pixels = ByteBuffer.allocate(Integer.BYTES * colours.length);
        pixels.asIntBuffer().put(colours);
        try {
            process.getOutputStream().write(pixels.array());
        } catch (IOException consequence) {
            throw failure();
        }
    }

    private void start(String size) throws IOException {
        String input = "-f rawvideo -pix_fmt 0rgb -s " + size + " -r " + framesPerSecond + " -i -";
        // The colours of yuv420p cover two by two pixels: an odd picture gets a black row or column.
        String shape = "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
        // A player that does not know how colours are coded guesses, and may make green darker.
        String colours = "-colorspace bt709 -color_range tv -color_primaries bt709 -color_trc iec61966-2-1";
        String output = "-c:v libx264 -pix_fmt yuv420p -crf 18 -movflags +faststart -f mp4";
        // without -xerror it counts a film as complete even if its end did not fit on the disk
        String options = String.join(" ", "-y -loglevel error -xerror", input, shape, colours, output);
        process = new ProcessBuilder(
                        Stream.of(Stream.of(program), Stream.of(options.split(" ")), Stream.of(pending.path()))
                                .flatMap(part -> part.map(Object::toString))
                                .toList())
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        complaints = CompletableFuture.supplyAsync(() -> String.join(
                "; ", process.errorReader(StandardCharsets.UTF_8).lines().toList()));
        // not a wait that can be interrupted: an interruption is a usual way to get here
        pending.stopAtEnd(() -> process.destroyForcibly().onExit().join());
    }

    @Override
    void complete() throws IOException {
        try {
            process.getOutputStream().close();
        } catch (IOException consequence) {
            throw failure();
        }
        if (process.onExit().join().exitValue() != 0) {
            throw failure();
        }
    }

    /** The reason is what ffmpeg says; that it no longer reads is only a consequence. */
    private IOException failure() throws IOException {
        int exitCode = process.onExit().join().exitValue();
        pending.requireOpen();
        // the hidden place means nothing to the user
        String said = complaints.join().replace(pending.path().toString(), pending.toString());
        return new IOException("ffmpeg failed with exit code " + exitCode + (said.isEmpty() ? "" : ": " + said));
    }
}
