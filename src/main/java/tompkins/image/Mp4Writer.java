package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** H.264 video, by feeding the pixels to the program ffmpeg. What it complains of becomes the message. */
final class Mp4Writer extends AnimationWriter {

    private final Path program;
    private final int framesPerSecond;
    private Process process;
    private OutputStream pixels;

    Mp4Writer(Path target, int framesPerSecond, Path program) throws IOException {
        super(target, PendingFile.file(target));
        this.program = program;
        this.framesPerSecond = framesPerSecond;
    }

    /** The program ffmpeg, looked for in the folders of a path; null is one without folders. */
    static Optional<Path> findProgram(String path) {
        if (path == null) {
            return Optional.empty();
        }
        return Pattern.compile(Pattern.quote(File.pathSeparator))
                .splitAsStream(path)
                .flatMap(folder -> Stream.of(new File(folder, "ffmpeg"), new File(folder, "ffmpeg.exe")))
                .filter(file -> file.isFile() && file.canExecute())
                .map(File::toPath)
                .findFirst();
    }

    /**
     * The program ffmpeg.
     *
     * @throws FileException if it is not on the path
     */
    static Path program() throws FileException {
        return findProgram(System.getenv("PATH"))
                .orElseThrow(() -> new FileException("ffmpeg: not found on the path; install it to save MP4 videos,"
                        + " or save an animated PNG, an animated GIF or numbered pictures"));
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        if (index == 0) {
            start(frame.getWidth(), frame.getHeight());
        }
        try {
            writeRows(frame);
        } catch (IOException e) {
            throw failure(e);
        }
    }

    private void start(int width, int height) throws IOException {
        process = new ProcessBuilder(command(width, height))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(complaints().toFile())
                .start();
        pixels = new BufferedOutputStream(process.getOutputStream(), 1 << 16);
    }

    /** What ffmpeg says, beside the pending file, with which it goes. */
    private Path complaints() {
        return pending().path().resolveSibling("ffmpeg.log");
    }

    private List<String> command(int width, int height) {
        String input = "-f rawvideo -pix_fmt rgb24 -s " + width + "x" + height + " -r " + framesPerSecond + " -i -";
        // The colours of yuv420p cover two by two pixels: an odd picture gets a black row or column.
        String shape = "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
        // A player that is not told how colours are coded guesses, and may turn green into something darker.
        String colours = "-colorspace bt709 -color_range tv -color_primaries bt709 -color_trc iec61966-2-1";
        String output = "-c:v libx264 -pix_fmt yuv420p -crf 18 -movflags +faststart -f mp4";
        List<String> command = new ArrayList<>(List.of(program.toString(), "-y", "-loglevel", "error"));
        command.addAll(List.of(String.join(" ", input, shape, colours, output).split(" ")));
        command.add(pending().path().toString());
        return command;
    }

    private void writeRows(BufferedImage frame) throws IOException {
        int width = frame.getWidth();
        int[] colours = new int[width];
        byte[] row = new byte[3 * width];
        for (int y = 0; y < frame.getHeight(); y++) {
            frame.getRGB(0, y, width, 1, colours, 0, width);
            for (int x = 0; x < width; x++) {
                row[3 * x] = (byte) (colours[x] >> 16);
                row[3 * x + 1] = (byte) (colours[x] >> 8);
                row[3 * x + 2] = (byte) colours[x];
            }
            pixels.write(row);
        }
    }

    @Override
    void complete(int frames) throws IOException {
        try {
            pixels.close();
        } catch (IOException e) {
            throw failure(e);
        }
        if (awaitExit() != 0) {
            throw failure(null);
        }
        abandon();
    }

    private int awaitExit() throws IOException {
        try {
            return process.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while ffmpeg was working");
        }
    }

    /** What ffmpeg says is the reason; that it no longer reads is only the consequence. */
    private IOException failure(IOException consequence) throws IOException {
        process.destroy();
        int exitCode = process.onExit().join().exitValue();
        String said = new String(Files.readAllBytes(complaints()), StandardCharsets.UTF_8).strip();
        String last = said.substring(said.lastIndexOf('\n') + 1).strip();
        IOException failure =
                new IOException("ffmpeg failed with exit code " + exitCode + (last.isEmpty() ? "" : ": " + last));
        if (consequence != null) {
            failure.addSuppressed(consequence);
        }
        return failure;
    }

    @Override
    void abandon() throws IOException {
        if (process != null) {
            // Not a wait that can be interrupted: an interruption is a usual way to get here.
            process.destroyForcibly().onExit().join();
            process.getOutputStream().close();
        }
    }
}
