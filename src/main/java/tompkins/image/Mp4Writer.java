package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.FileFailure;
import tompkins.file.PendingFile;

/** H.264 video, made by feeding the pixels to the program ffmpeg. What it complains about becomes the message. */
final class Mp4Writer extends AnimationWriter {

    private static final String ENCODER = "libx264";

    private static final String INSTEAD = "save an animated PNG, an animated GIF or numbered pictures";

    /** What the system says, and ffmpeg at the end of a line. */
    private static final String FULL_DISK = "No space left on device";

    /**
     * How long to wait for the end of the complaints: programs that ffmpeg has started may live on and keep it open.
     */
    private static final long PATIENCE_MILLISECONDS = 1000;

    private final Path program;
    private final int framesPerSecond;
    private final Deque<String> complaints = new ConcurrentLinkedDeque<>();
    private Process process;
    private Thread listener;
    private OutputStream pixels;

    Mp4Writer(PendingFile pending, int framesPerSecond, Path program) {
        super(pending);
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
                .orElseThrow(() -> new FileException(
                        "ffmpeg: not found on the path; install it to save MP4 videos," + " or " + INSTEAD));
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
                .start();
        listener = new Thread(() -> listen(process.errorReader(StandardCharsets.UTF_8)), "tompkins-ffmpeg");
        listener.setDaemon(true);
        listener.start();
        pending().stopAtEnd(this::kill);
        pixels = new BufferedOutputStream(process.getOutputStream(), 1 << 16);
    }

    private void kill() throws IOException {
        // not a wait that can be interrupted: an interruption is a usual way to get here
        process.destroyForcibly().onExit().join();
        process.getOutputStream().close();
    }

    private List<String> command(int width, int height) {
        String input = "-f rawvideo -pix_fmt rgb24 -s " + width + "x" + height + " -r " + framesPerSecond + " -i -";
        // The colours of yuv420p cover two by two pixels: an odd picture gets a black row or column.
        String shape = "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
        // A player that does not know how colours are coded guesses, and may make green darker.
        String colours = "-colorspace bt709 -color_range tv -color_primaries bt709 -color_trc iec61966-2-1";
        String output = "-c:v " + ENCODER + " -pix_fmt yuv420p -crf 18 -movflags +faststart -f mp4";
        // without -xerror it counts a film as complete even if its end did not fit on the disk
        List<String> command = new ArrayList<>(List.of(program.toString(), "-y", "-loglevel", "error", "-xerror"));
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
    }

    private int awaitExit() throws IOException {
        try {
            return process.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while ffmpeg was working");
        }
    }

    /** The reason is what ffmpeg says; that it no longer reads is only a consequence. */
    private IOException failure(IOException consequence) throws IOException {
        // not by the process itself, which would close the stream of its complaints
        process.toHandle().destroy();
        int exitCode = process.onExit().join().exitValue();
        if (pending().isEnded()) {
            return new InterruptedIOException(FileFailure.STOPPED);
        }
        awaitComplaints();
        IOException failure = new IOException(reason(exitCode));
        if (consequence != null) {
            failure.addSuppressed(consequence);
        }
        return failure;
    }

    private String reason(int exitCode) {
        if (complaints.stream().anyMatch(line -> line.endsWith(FULL_DISK))) {
            return FULL_DISK;
        }
        Optional<String> encoder =
                complaints.stream().filter(line -> line.contains(ENCODER)).findFirst();
        if (encoder.isPresent()) {
            return "ffmpeg cannot make such videos: " + encoder.get() + "; install one that can, or " + INSTEAD;
        }
        String last = complaints.isEmpty() ? "" : ": " + complaints.getLast();
        // the hidden place means nothing to the user
        return "ffmpeg failed with exit code " + exitCode
                + last.replace(pending().path().toString(), pending().toString());
    }

    /** Keeps what the program complains of, in memory because the disk may be full. */
    private void listen(BufferedReader text) {
        try (text) {
            text.lines().map(String::strip).filter(line -> !line.isEmpty()).forEach(complaints::add);
        } catch (IOException | UncheckedIOException ended) {
            // there is nothing more to read
        }
    }

    /** Waits for the last complaint of a program that has ended. */
    private void awaitComplaints() {
        try {
            listener.join(PATIENCE_MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
