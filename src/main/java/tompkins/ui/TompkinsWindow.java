package tompkins.ui;

import java.awt.BorderLayout;
import java.awt.Desktop;
import java.awt.desktop.QuitStrategy;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import tompkins.lesson.Lesson;
import tompkins.studio.Studio;
import tompkins.ui.animate.AnimationExport;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.compare.PeekKey;
import tompkins.ui.editor.ChooseTool;
import tompkins.ui.editor.FileContentEditor;
import tompkins.ui.exchange.ClipboardActions;
import tompkins.ui.exchange.FileDialogs;
import tompkins.ui.exchange.PhotographExport;
import tompkins.ui.exchange.SceneOpener;
import tompkins.ui.exchange.SceneSaver;
import tompkins.ui.exchange.SheetExport;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ChosenFile;
import tompkins.ui.lesson.LessonCourse;
import tompkins.ui.lesson.LessonPanel;
import tompkins.ui.measure.MeasureMarks;
import tompkins.ui.measure.MeasureTool;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.model.Throttle;
import tompkins.ui.overlay.PictureOverlays;
import tompkins.ui.photograph.Captions;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.photograph.StatusBar;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.ride.Motion;
import tompkins.ui.widget.Faults;
import tompkins.ui.widget.FocusFollower;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.TabStrip;

/** The window of Tompkins: the photograph, and a narrow panel with what it depends on. */
public final class TompkinsWindow {

    final Settings settings = new Settings();
    private final JFrame frame = new JFrame();
    private final StudioModel model;
    private final PhotographView view;
    final SidePanel side;
    private final StatusBar status;
    final WindowParts parts;
    private final FileDialogs dialogs;
    final SceneSaver saver;
    final TabStrip strip;
    final LessonCourse course = new LessonCourse(settings, this::openExample);
    private final LessonPanel lesson;
    final SceneOpener opener;
    final Captions captions;
    final PictureOverlays overlays;
    final MeasureTool measure;
    final ClipboardActions clipboard;
    private final Menus menus;
    final FullScreen fullScreen;
    final Motion motion;

    /** Completes the window after a second, or as soon as there is a picture. */
    private final Timer completion;

    /** When there is time to tell of the pictures of a ride. */
    private final Throttle throttle = new Throttle();

    private TompkinsWindow(FirstScene first, Supplier<List<Studio>> examples) {
        settings.look().install();
        completion = new Timer(1000, event -> complete(examples));
        completion.setRepeats(false);
        model = new StudioModel(first.studio(), first.file() == null ? null : ChosenFile.plain(first.file()));
        // first, so that all parts have answered when it begins
        model.addOpenListener(this::beginLesson);
        PictureListener pictures = new PictureListener();
        view = new PhotographView(model, pictures);
        // the window is built while it is worked on
        view.render();
        status = new StatusBar(view.controller());
        strip = new TabStrip();
        MeasureMarks lessonMarks = new MeasureMarks(view::otherPicture);
        view.canvas().addOverlay(lessonMarks);
        lesson = new LessonPanel(model, course, new LessonPicture(this, lessonMarks));
        parts = new WindowParts(frame, model, view, status, settings);
        dialogs = new FileDialogs(parts, this::pause);
        saver = new SceneSaver(parts, dialogs);
        opener = new SceneOpener(parts, dialogs, saver);
        captions = new Captions(
                view.canvas(), settings, first.besideRest() || model.studio().lesson() instanceof Lesson);
        overlays = new PictureOverlays(model, view.canvas(), settings, view.asker());
        motion = new Motion(parts, strip, new AnimationExport(frame, dialogs, captions, overlays), captions);
        motion.pilot().addListener(pictures::tellLast);
        clipboard = new ClipboardActions(parts, captions, overlays);
        measure = new MeasureTool(view, clipboard::copyMeasured);
        strip.fill(TabStrip.Tab.MEASURE, measure::component, measure::setOn);
        // it asks for the panel and the full screen, made below, only when they are chosen
        menus = new Menus(this);
        frame.setJMenuBar(menus.bar());
        side = new SidePanel(model, view, lesson.component(), menus.buttons(), this::tellTool);
        if (first.besideRest()) {
            side.compare.begin(ComparePanel.Other.AT_REST);
        }
        // a ride begins with the picture alone
        motion.pilot().setWhenBegun(() -> side.compare.choose(ComparePanel.Other.NOTHING));
        frame.setContentPane(content());
        new ChooseTool(model, view, side::isEditing, side::edit);
        view.setMenu(new PictureMenu(this));
        // also while the menus are hidden
        menus.bindKeys(frame.getRootPane());
        frame.getRootPane().putClientProperty(FileContentEditor.CHOOSERS, dialogs);
        fullScreen = new FullScreen(frame, side.component(), List.of(menus.bar(), status.component()));
        frame.getRootPane().setTransferHandler(opener.drop());
        PeekKey.bind(frame, view.canvas());
        FocusFollower.install(frame);
        Screens.keepDialogsOnScreen(frame, this::pause);
        frame.setName("tompkins");
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.setSize(WindowSize.kept(frame, settings));
        WindowSize size = new WindowSize(frame, settings);
        frame.addWindowListener(new WindowCloser(frame, opener, size::save, this::end));
        frame.setLocationRelativeTo(null);
        model.addOpenListener(status::clear);
        model.follow(this::showTitle);
        // a layout made before the window is on its screen would be made again
        frame.addNotify();
        frame.setMinimumSize(WindowSize.least(frame));
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
     */
    public static void open(FirstScene first, Supplier<List<Studio>> examples) {
        prepare();
        if (Desktop.isDesktopSupported() && Desktop.getDesktop().isSupported(Desktop.Action.APP_QUIT_STRATEGY)) {
            // Cmd+Q on a Mac must not pass over the question about unsaved changes
            Desktop.getDesktop().setQuitStrategy(QuitStrategy.CLOSE_ALL_WINDOWS);
        }
        SwingUtilities.invokeLater(() -> {
            Thread.currentThread().setUncaughtExceptionHandler(new Faults());
            TompkinsWindow window = opened(first, examples);
            first.tellProblem(window.frame);
        });
    }

    /** Opens a window at once; called by the event thread. */
    static TompkinsWindow opened(FirstScene first, Supplier<List<Studio>> examples) {
        TompkinsWindow window = new TompkinsWindow(first, examples);
        window.frame.setVisible(true);
        if (window.model.studio().lesson() instanceof Lesson) {
            window.beginLesson();
        }
        if (window.model.file() != null) {
            window.settings.addRecentFile(window.model.file());
        }
        window.completion.start();
        return window;
    }

    /** Adds what takes time, after the first picture: the rows of the panel, the icon and the examples. */
    private void complete(Supplier<List<Studio>> examples) {
        side.addRows();
        frame.setIconImages(WindowIcon.images());
        view.asker().ask(menus, examples, menus::setExamples);
    }

    private void beginLesson() {
        JComponent keys = view.canvas();
        if (lesson.begin()) {
            strip.close();
            side.setEditing(false);
            side.setShown(true);
            keys = lesson.entry();
        }
        // what had them may have nothing to do in this scene
        SwingUtilities.invokeLater(keys::requestFocusInWindow);
    }

    private void openExample(Studio example) {
        opener.open(example);
    }

    /** While all controls are there, lamps are marked in the picture, and a click chooses. */
    private void tellTool() {
        view.canvas().repaint();
        view.tellTool();
    }

    void pause() {
        motion.pause();
    }

    JFrame frame() {
        return frame;
    }

    StudioModel model() {
        return model;
    }

    PhotographView view() {
        return view;
    }

    private JComponent content() {
        JPanel middle = new JPanel(new BorderLayout());
        middle.add(view.canvas(), BorderLayout.CENTER);
        middle.add(strip.component(), BorderLayout.SOUTH);
        JPanel content = new JPanel(new BorderLayout());
        content.add(middle, BorderLayout.CENTER);
        content.add(side.component(), BorderLayout.EAST);
        content.add(status.component(), BorderLayout.SOUTH);
        return content;
    }

    private void showTitle() {
        String file = model.file() == null ? "" : " \u2013 " + model.file().getFileName();
        String title = model.studio().title();
        frame.setTitle((model.isModified() ? "\u2022 " : "") + title + file + " \u2013 Tompkins");
    }

    private void end() {
        completion.stop();
        pause();
        status.stop();
        view.close();
    }

    private final class PictureListener implements PhotographView.Listener {

        @Override
        public void shown(Picture picture) {
            if (completion.isRunning()) {
                completion.setInitialDelay(0);
                completion.restart();
            }
            // nobody can read thirty texts a second, and the pictures need the time
            if (motion == null || !motion.pilot().isRiding() || throttle.admits()) {
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
        public void read(PixelReading reading, boolean rests) {
            status.show(reading, rests);
        }

        @Override
        public void pinned(PixelReading reading, String picture) {
            side.show(reading, picture);
        }

        @Override
        public void hints(String click) {
            status.showHint(click);
        }

        @Override
        public void noPicture(String message) {
            status.fail(message);
        }

        @Override
        public void failed(String message) {
            status.say(message);
        }
    }

    void savePhotograph() {
        new PhotographExport(parts, dialogs).ask();
    }

    void saveLessonSheet() {
        new SheetExport(parts, dialogs).ask(course.lessons());
    }

    void setLook(Look look) {
        look.install();
        settings.setLook(look);
        // a size does not follow the look by itself
        frame.setMinimumSize(WindowSize.least(frame));
    }

    void togglePanel() {
        side.setShown(!side.component().isVisible());
        frame.revalidate();
    }

    void toggleRendering() {
        if (view.controller().isStopped()) {
            view.render();
        } else {
            view.stop();
        }
    }

    /** Ends the innermost of what goes on. */
    void leave() {
        if (!motion.pauseIfMoving() && !strip.closeIfOpen(TabStrip.Tab.MEASURE) && !fullScreen.leave()) {
            BackgroundTask.cancelLast(frame);
        }
    }

    void close() {
        frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
    }
}
