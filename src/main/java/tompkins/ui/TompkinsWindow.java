package tompkins.ui;

import java.awt.BorderLayout;
import java.awt.Desktop;
import java.awt.desktop.QuitStrategy;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.PlainPath;
import tompkins.ui.model.Seldom;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.LessonPanel;
import tompkins.ui.picture.Pace;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PixelProbe;
import tompkins.ui.widget.FocusFollower;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

/** The window of Tompkins: the photograph, and a narrow panel with what it depends on. */
public final class TompkinsWindow {

    /** Sizes of the window at first, in sizes of its type. */
    private static final double WIDTH = 84;

    private static final double HEIGHT = 60;
    private static final double MINIMUM_WIDTH = 40;
    private static final double MINIMUM_HEIGHT = 24;

    private final Settings settings = new Settings();
    private final JFrame frame = new JFrame();
    private final WindowSize size;
    private final StudioModel model;
    private final PhotographView view;
    private final SideRoom side;
    private final StatusBar status;
    private final FileDialogs dialogs;
    private final SceneSaver saver;
    private final LessonPanel lesson;
    private final SceneOpener opener;
    private final Captions captions;
    private final Signs signs;
    private final MeasureTool measure;
    private final ClipboardActions clipboard;
    private final Menus menus;
    private final LateParts late;
    private final EditorDialog editor;
    private final FullScreen fullScreen;
    private final JPanel middle = new JPanel(new BorderLayout());

    private final Motion motion;

    /** The file of the first scene, or null. */
    private final Path place;

    /** When there is time to tell of the pictures of a ride. */
    private final Seldom seldom = new Seldom();

    private TompkinsWindow(FirstScene first, CommandLineWriter commandLine) {
        settings.look().install();
        place = first.file() == null ? null : PlainPath.of(first.file());
        model = new StudioModel(first.studio(), place);
        PictureListener pictures = new PictureListener();
        view = new PhotographView(model, pictures, this::pace);
        // the window is built while it is worked on
        view.render();
        status = new StatusBar(view.controller());
        side = new SideRoom(() -> new SidePanel(model, view, first.besideRest(), status::report, this::edit));
        dialogs = new FileDialogs(frame, model, status, settings);
        saver = new SceneSaver(frame, model, status, dialogs);
        lesson = new LessonPanel(model);
        opener = new SceneOpener(frame, model, view, status, settings, dialogs, saver, this::pause, this::beginLesson);
        captions = new Captions(view.canvas(), settings, first.besideRest());
        signs = new Signs(view.canvas(), settings, view::fail);
        motion = new Motion(frame, model, view, status, new AnimationExport(frame, dialogs, captions, signs), captions);
        motion.pilot().addListener(pictures::tellLast);
        frame.setContentPane(content());
        clipboard = new ClipboardActions(frame, model, view, captions, signs, commandLine, status);
        measure = new MeasureTool(view, motion.bars(), clipboard::copyMeasured);
        menus = new Menus(
                opener,
                saver,
                clipboard,
                new History(model, frame, this::pause, this::sayOtherScene),
                settings,
                captions,
                motion,
                signs,
                view.canvas().zoom(),
                new HelpCommands(frame, opener),
                new WindowCommands());
        frame.setJMenuBar(menus.bar());
        editor = new EditorDialog(frame, model, dialogs, menus::bindKeys);
        late = new LateParts(this::furnish, menus::setExamples, frame::setIconImages);
        // also while the menus are hidden
        menus.bindKeys(frame.getRootPane());
        fullScreen = new FullScreen(frame, side, List.of(menus.bar(), status.component()));
        frame.getRootPane().setTransferHandler(opener.drop());
        PeekKey.bind(frame, view.canvas());
        FocusFollower.install(frame);
        Screens.keepDialogsOnScreen(frame);
        frame.setName("tompkins");
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new Closer());
        frame.setSize(Screens.atMost(
                frame, settings.number("width", Look.pixels(WIDTH)), settings.number("height", Look.pixels(HEIGHT))));
        size = new WindowSize(frame, settings);
        frame.setLocationByPlatform(true);
        model.addListener(this::showTitle);
        showTitle();
        // a layout made before the window is on its screen would be made again
        frame.addNotify();
        fitToLook();
        settings.tellTrouble(status::say);
    }

    /**
     * Starts on the event thread what takes longest before a window can be opened. Called early if a window is likely
     * to be opened; returns at once. Needs a display.
     */
    public static void prepare() {
        // the texts of the window are English; those of file choosers and keys must not be in another language
        Locale.setDefault(Locale.ENGLISH);
        SwingUtilities.invokeLater(() -> new Settings().look().install());
    }

    /**
     * Opens a window, which shows its first picture as soon as that is there. Called by any thread; returns at once.
     * The program ends when all its windows are closed.
     *
     * @param first the scene to show
     * @param examples reads the scenes that the menu of examples offers, in its order; called by another thread
     * @param commandLine writes the command line that takes the same photograph
     */
    public static void open(FirstScene first, Supplier<List<Studio>> examples, CommandLineWriter commandLine) {
        prepare();
        if (Desktop.isDesktopSupported() && Desktop.getDesktop().isSupported(Desktop.Action.APP_QUIT_STRATEGY)) {
            // Cmd+Q on a Mac must not pass over the question about unsaved changes
            Desktop.getDesktop().setQuitStrategy(QuitStrategy.CLOSE_ALL_WINDOWS);
        }
        SwingUtilities.invokeLater(() -> {
            Thread.currentThread().setUncaughtExceptionHandler(new LastResort());
            TompkinsWindow window = opened(first, examples, commandLine);
            first.tellProblem(window.frame);
        });
    }

    /** Opens a window at once; called by the event thread. */
    static TompkinsWindow opened(FirstScene first, Supplier<List<Studio>> examples, CommandLineWriter commandLine) {
        TompkinsWindow window = new TompkinsWindow(first, commandLine);
        window.frame.setVisible(true);
        window.late.prepare(examples);
        return window;
    }

    /**
     * Says that undo or redo has led to another scene, which may not have been meant. The pin goes: it belongs to its
     * scene.
     */
    private void sayOtherScene() {
        view.setPin(null);
        status.report(Texts.get("history.otherScene", model.studio().title()));
    }

    /** A lesson needs the room of the bars under the picture. */
    private void beginLesson() {
        if (lesson.begin()) {
            motion.closeBars();
            measure.end();
        }
    }

    private void edit(StudioPath part) {
        editor.open(part);
    }

    /** Brings the panel, and remembers the file. The picture pauses meanwhile, so that the panel has the processors. */
    private void furnish() {
        // a window that was closed meanwhile has no picture
        boolean unfinished = frame.isDisplayable() && view.controller().isBusy();
        view.stop();
        side.panel();
        if (unfinished) {
            view.render();
        }
        if (place != null) {
            settings.addRecentFile(place);
        }
    }

    private Pace pace() {
        return motion == null ? Pace.HAND : motion.pace();
    }

    private void pause() {
        motion.pause();
    }

    Motion motion() {
        return motion;
    }

    JFrame frame() {
        return frame;
    }

    SideRoom side() {
        return side;
    }

    StudioModel model() {
        return model;
    }

    PhotographView view() {
        return view;
    }

    SceneSaver saver() {
        return saver;
    }

    private JComponent content() {
        middle.add(view.canvas(), BorderLayout.CENTER);
        JPanel below = new JPanel(new BorderLayout());
        below.add(lesson.component(), BorderLayout.CENTER);
        below.add(motion.bars(), BorderLayout.SOUTH);
        middle.add(below, BorderLayout.SOUTH);
        JPanel content = new JPanel(new BorderLayout());
        content.add(middle, BorderLayout.CENTER);
        content.add(side.component(), BorderLayout.EAST);
        content.add(status.component(), BorderLayout.SOUTH);
        side.fitInto(content, status::showPanelFolded);
        return content;
    }

    /** Sets the sizes that do not follow the look by themselves. */
    private void fitToLook() {
        side.fitToLook();
        size.require(Screens.atMost(frame, Look.pixels(MINIMUM_WIDTH), Look.pixels(MINIMUM_HEIGHT)));
    }

    private void showTitle() {
        String file = model.file() == null ? "" : " \u2013 " + model.file().getFileName();
        String title = SidePanel.titled(model, model.studio().title());
        frame.setTitle((model.isModified() ? "\u2022 " : "") + title + file + " \u2013 Tompkins");
    }

    private final class Closer extends WindowAdapter {

        @Override
        public void windowClosing(WindowEvent event) {
            if (!BackgroundTask.showRunning(frame)) {
                opener.leaveScene(this::close);
            }
        }

        private void close() {
            size.save();
            frame.dispose();
        }

        @Override
        public void windowClosed(WindowEvent event) {
            pause();
            status.stop();
            view.close();
            signs.close();
            measure.dispose();
            editor.dispose();
        }
    }

    private final class PictureListener implements PhotographView.Listener {

        @Override
        public void shown(Picture picture) {
            late.firstPictureDone();
            // nobody can read thirty texts a second, and the pictures need the time
            if (motion == null || !motion.pilot().isRiding() || seldom.mayHappen()) {
                tell(picture);
            }
            measure.show();
        }

        private void tell(Picture picture) {
            side.show(picture);
            if (picture.studio().equals(model.studio())) {
                status.endFailure();
            }
            status.show(picture);
        }

        /** What was not said of the last picture of a ride. */
        void tellLast() {
            Picture last = view.canvas().shown().now();
            if (last != null && !motion.pilot().isRiding()) {
                tell(last);
            }
        }

        @Override
        public void read(PixelProbe.Reading reading) {
            status.show(reading);
        }

        @Override
        public void pinned(PixelProbe.Reading reading, String picture) {
            side.panel().show(reading, picture);
        }

        @Override
        public void picking(boolean picking) {
            status.showPicking(picking);
        }

        @Override
        public void noPicture(String message) {
            late.firstPictureDone();
            status.fail(message);
        }

        @Override
        public void failed(String message) {
            status.say(message);
        }
    }

    private final class WindowCommands implements Menus.Commands {

        @Override
        public void savePhotograph() {
            new PhotographExport(frame, model, view, status, dialogs).ask();
        }

        @Override
        public void setLook(Look look) {
            look.install();
            settings.setLook(look);
            fitToLook();
            editor.fitToLook();
        }

        @Override
        public void editScene() {
            editor.open();
        }

        @Override
        public void editNewScene() {
            editor.open(StudioPath.ROOT);
        }

        @Override
        public void togglePanel() {
            side.toggle();
            frame.revalidate();
        }

        @Override
        public void toggleFullScreen() {
            fullScreen.toggle();
        }

        @Override
        public void toggleMeasuring() {
            measure.toggle();
        }

        @Override
        public void stop() {
            if (!motion.pauseIfMoving() && !view.endPicking() && !measure.end() && !fullScreen.leave()) {
                view.stop();
            }
        }

        @Override
        public void close() {
            frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
        }

        @Override
        public void copyAnimation() {
            motion.wantedAnimation().ifPresent(clipboard::copyCommandLine);
        }
    }
}
