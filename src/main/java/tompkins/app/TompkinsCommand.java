package tompkins.app;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import tompkins.io.BundledScenes;
import tompkins.io.Spelling;
import tompkins.io.StudioReader;
import tompkins.property.MistakeException;
import tompkins.ui.FirstScene;
import tompkins.ui.TompkinsWindow;

/** The program as a whole. */
@Command(
        name = TompkinsCommand.NAME,
        description = "Takes photographs with a camera that moves at nearly the speed of light.",
        footer = {
            "",
            "Without a command: opens the window, with a scene file or saved photograph if one is given; without a display,"
                    + " takes the photograph."
        })
final class TompkinsCommand extends ProgramCommand {

    /** The name of the command that shows the help of another one. */
    static final String HELP = "help";

    /** The name of the program. */
    static final String NAME = "tompkins";

    private static final String RENDER = "render";

    /** The commands by name, in the order in which the help lists them. */
    private static final Map<String, Class<?>> COMMANDS = new LinkedHashMap<>();

    static {
        COMMANDS.put(RENDER, RenderCommand.class);
        COMMANDS.put("animate", AnimateCommand.class);
        COMMANDS.put("check", CheckCommand.class);
        COMMANDS.put("explain", ExplainCommand.class);
        COMMANDS.put("trace", TraceCommand.class);
        COMMANDS.put("measure", MeasureCommand.class);
        COMMANDS.put("sheet", SheetCommand.class);
        COMMANDS.put("study", StudyCommand.class);
        COMMANDS.put("completion", CompletionCommand.class);
        COMMANDS.put(HELP, HelpCommand.class);
    }

    @Parameters(arity = "0..1", paramLabel = "SCENE", description = "scene file or saved photograph to open")
    private Path scene;

    private final BooleanSupplier display;

    private TompkinsCommand(BooleanSupplier display) {
        this.display = display;
    }

    /**
     * The command line for some arguments. If they call a command, it knows only that one, and none if they open the
     * window: to look at all of them would take a tenth of a second of every start.
     *
     * @param display whether a window can be opened
     */
    static CommandLine commandLine(BooleanSupplier display, String... arguments) {
        // it would look for types that no option has
        System.setProperty("picocli.converters.excludes", "java[.](sql|time)[.].*");
        CommandLine commandLine = new CommandLine(new TompkinsCommand(display));
        if (isNamedBy(arguments)) {
            return commandLine.addSubcommand(arguments[0], COMMANDS.get(arguments[0]));
        }
        if (!opensWindow(arguments)) {
            COMMANDS.forEach(commandLine::addSubcommand);
        }
        return commandLine;
    }

    /** The command line with all commands. */
    static CommandLine withAllCommands() {
        return commandLine(() -> false, "--help");
    }

    /** Whether some arguments call one of the commands, none of which opens a window. */
    static boolean isNamedBy(String... arguments) {
        return arguments.length > 0 && COMMANDS.containsKey(arguments[0]);
    }

    /** Whether some arguments ask for a window, provided that there is nothing wrong with them; quickly decided. */
    static boolean opensWindow(String... arguments) {
        return arguments.length == 0 || arguments.length == 1 && !isNamedBy(arguments) && !arguments[0].startsWith("-");
    }

    /** The scene of the window; a file that cannot be read is reported there, because there may be no console. */
    private FirstScene firstScene() throws IOException {
        try {
            return scene == null
                    ? FirstScene.ofProgram(BundledScenes.firstStudio(), "")
                    : new FirstScene(StudioReader.read(scene), scene);
        } catch (MistakeException mistakes) {
            return withProblem(mistakes.getMessage());
        } catch (OutOfMemoryError tooMuch) {
            return withProblem(Failures.memoryMessage(scene));
        }
    }

    private FirstScene withProblem(String problem) throws IOException {
        problem.lines().forEach(err()::println);
        return FirstScene.ofProgram(BundledScenes.firstStudio(), problem);
    }

    /** What is wrong with a word in the place of a command or a scene. */
    static String unknownWord(String word) {
        return word + ": there is neither a file nor a command of this name; the commands are "
                + String.join(", ", COMMANDS.keySet()) + Spelling.hint(word, COMMANDS.keySet());
    }

    /** Whether a word looks like the name of a file, and not like that of a command. */
    private static boolean isFileName(String word) {
        return word.contains(".") || word.contains(File.separator);
    }

    @Override
    public Integer call() throws Exception {
        boolean hasDisplay = display.getAsBoolean();
        if (scene != null && Files.notExists(scene) && !(hasDisplay && isFileName(scene.toString()))) {
            throw new MistakeException(unknownWord(scene.toString()));
        }
        if (hasDisplay) {
            TompkinsWindow.open(firstScene(), BundledScenes::studios);
            return Failures.WINDOW_IS_OPEN;
        }
        err().println("There is no display: taking the photograph instead of opening the window.");
        try (Photographer photographer =
                new Photographer(commandLine(), Runtime.getRuntime().availableProcessors())) {
            photographer.takeDefault(scene == null ? BundledScenes.first() : scene, NamedFile.currentFolder());
        }
        return 0;
    }
}
