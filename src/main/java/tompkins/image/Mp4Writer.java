package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.FileFailure;
import tompkins.file.PendingFile;

/** H.264 video, made by feeding the pixels to the program ffmpeg. What it complains about becomes the message. */
final class Mp4Writer extends AnimationWriter {

    private final Path program;
    private final PendingFile pending;
    private final int framesPerSecond;
    private Process process;
    private CompletableFuture<String> complaints;

    Mp4Writer(Path target, PendingFile pending, int framesPerSecond, Path program) {
        super(target);
        this.pending = pending;
        this.program = program;
        this.framesPerSecond = framesPerSecond;
    }

    /** The program ffmpeg in the folders of a path, or null if it is in none; null is a path without folders. */
    static Path findProgram(String path) {
        Stream<String> folders = path == null
                ? Stream.empty()
                : Pattern.compile(Pattern.quote(File.pathSeparator)).splitAsStream(path);
        return folders.flatMap(folder -> Stream.of(new File(folder, "ffmpeg"), new File(folder, "ffmpeg.exe")))
                .filter(file -> file.isFile() && file.canExecute())
                .map(File::toPath)
                .findFirst()
                .orElse(null);
    }

    /**
     * The program ffmpeg.
     *
     * @throws FileException if it is not on the path
     */
    static Path program() throws FileException {
        return Optional.ofNullable(findProgram(System.getenv("PATH")))
                .orElseThrow(() -> new FileException("ffmpeg: not found on the path; install it to save MP4 videos,"
                        + " or save an animated GIF or numbered pictures"));
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        int width = frame.getWidth();
        int height = frame.getHeight();
        if (index == 0) {
            start(width, height);
        }
        ByteBuffer pixels = ByteBuffer.allocate(Integer.BYTES * width * height);
        pixels.asIntBuffer().put(frame.getRGB(0, 0, width, height, null, 0, width));
        try {
            process.getOutputStream().write(pixels.array());
        } catch (IOException consequence) {
            throw failure();
        }
    }

    private void start(int width, int height) throws IOException {
        String input = "-f rawvideo -pix_fmt 0rgb -s " + width + "x" + height + " -r " + framesPerSecond + " -i -";
        // The colours of yuv420p cover two by two pixels: an odd picture gets a black row or column.
        String shape = "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
        // A player that does not know how colours are coded guesses, and may make green darker.
        String colours = "-colorspace bt709 -color_range tv -color_primaries bt709 -color_trc iec61966-2-1";
        String output = "-c:v libx264 -pix_fmt yuv420p -crf 18 -movflags +faststart -f mp4";
        // without -xerror it counts a film as complete even if its end did not fit on the disk
        List<String> command = new ArrayList<>(List.of(program.toString(), "-y", "-loglevel", "error", "-xerror"));
        command.addAll(List.of(String.join(" ", input, shape, colours, output).split(" ")));
        command.add(pending.path().toString());
        process = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        complaints = CompletableFuture.supplyAsync(this::readComplaints);
        // not a wait that can be interrupted: an interruption is a usual way to get here
        pending.stopAtEnd(() -> process.destroyForcibly().onExit().join());
    }

    /** All that the program says, in one line and in memory, because the disk may be full. */
    private String readComplaints() {
        try (Stream<String> lines = process.errorReader(StandardCharsets.UTF_8).lines()) {
            return lines.map(String::strip).filter(line -> !line.isEmpty()).collect(Collectors.joining("; "));
        } catch (UncheckedIOException ended) {
            return "";
        }
    }

    @Override
    Path complete(int frames) throws IOException {
        try (OutputStream end = process.getOutputStream()) {
            end.flush();
        } catch (IOException consequence) {
            throw failure();
        }
        if (process.onExit().join().exitValue() != 0) {
            throw failure();
        }
        return pending.commit();
    }

    /** The reason is what ffmpeg says; that it no longer reads is only a consequence. */
    private IOException failure() {
        int exitCode = process.onExit().join().exitValue();
        if (pending.isEnded()) {
            return new InterruptedIOException(FileFailure.STOPPED);
        }
        // the hidden place means nothing to the user
        String said = complaints.join().replace(pending.path().toString(), pending.toString());
        return new IOException("ffmpeg failed with exit code " + exitCode + (said.isEmpty() ? "" : ": " + said));
    }

    @Override
    void discard(int frames) throws IOException {
        pending.close();
    }
}
