package tompkins.ui.editor;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.light.LightSource;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.surface.FrameWindow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Column;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.TinyDrawing;
import tompkins.ui.widget.Wording;

/** All of the studio: a tree of its parts, and a form for the chosen one. */
public final class SceneEditor extends Part {

    private static final StudioPath SCENE = StudioPath.ROOT.then("scene");
    private static final StudioPath LIGHTS = StudioPath.ROOT.then("lights");
    private static final StudioPath ON_BOARD = StudioPath.ROOT.then("cameraFrame");

    /** The height of the tree at first, in sizes of the type. */
    private static final double TREE = 15;

    private final StudioModel model;
    private final StudioTree tree = new StudioTree(this::leaveFor);
    private final Column formPanel = new Column();
    private final Note note = new Note("");
    private final JButton add = Buttons.of("tree.add", this::offerTypes);
    private final JButton duplicate = button("duplicate", this::duplicate, 1);
    private final JButton hide = button("hide", this::hideOrShow, 0);
    private final JButton up = button("up", list -> Collections.swap(list, place(), place() - 1), -1);
    private final JButton down = button("down", list -> Collections.swap(list, place(), place() + 1), 1);
    private final JButton remove = Buttons.of("tree.remove", this::remove);
    private final JButton match = Buttons.of("window.match", this::matchCamera);
    private StudioTree.Line line;
    private FamilyEditor form;
    private Studio shown;

    /** An editor of the studio in a model, which follows its changes. */
    public SceneEditor(StudioModel model) {
        super(new JPanel(
                new MigLayout("novisualpadding, insets 6, fill, wrap 1, gap 0 6", "[grow,fill]", "[grow,fill][]")));
        this.model = model;
        JScrollPane upper = new JScrollPane(tree.component());
        upper.setPreferredSize(new Dimension(0, Look.pixels(TREE)));
        JScrollPane lower = formPanel.scrolled("form");
        // it takes what the tree leaves, and scrolls
        lower.setPreferredSize(new Dimension(0, 0));
        JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, upper, lower);
        split.getAccessibleContext().setAccessibleName(Texts.get("tree.split"));
        Keys.freeForWindow(split);
        panel.add(split, "wmin 0");
        JPanel buttons = Rows.of("wrap 3, hidemode 3, gap 4", "[grow,fill,sg][grow,fill,sg][grow,fill,sg]");
        for (JButton each : List.of(add, duplicate, hide, up, down, remove)) {
            buttons.add(each, "wmin 0");
        }
        buttons.add(match, "span");
        panel.add(buttons, "wmin 0");
        Keys.bindFocused(tree.component(), KeyStroke.getKeyStroke("DELETE"), remove::doClick);
        model.follow(this::update);
    }

    private JButton button(String key, Consumer<List<Object>> change, int step) {
        return Buttons.of("tree." + key, () -> changeList(change, step));
    }

    /** Puts a copy after an element; that of an object gets a name that no other element has. */
    private void duplicate(List<Object> list) {
        Object element = list.get(place());
        list.add(place() + 1, element instanceof SceneObject object ? named(object, list) : element);
    }

    private static SceneObject named(SceneObject object, List<Object> list) {
        List<String> taken = list.stream().map(Wording::nameOf).toList();
        String name = object.description().replaceFirst(" \\d+$", "");
        int number = 2;
        while (taken.contains(name + " " + number)) {
            number++;
        }
        return Hiding.renamed(object, name + " " + number);
    }

    private void hideOrShow(List<Object> list) {
        list.set(place(), Hiding.hiddenOrShown((SceneObject) list.get(place())));
    }

    private void remove() {
        // what was typed is removed with its entry
        EntryField.in(formPanel).forEach(EntryField::revert);
        changeList(list -> list.remove(place()), 0);
    }

    /** Gives the window in front of the lens the velocity of the camera, which it follows from then on. */
    private void matchCamera() {
        Studio studio = model.studio();
        FrontWindow.of(studio)
                .ifPresent(window -> model.set(FrontWindow.with(studio, window.withVelocity(studio.velocity()))));
    }

    private void update() {
        Studio studio = model.studio();
        if (studio == shown) {
            return;
        }
        boolean sameTree = shown != null
                && studio.hasSameObjects(shown)
                && studio.lesson().equals(shown.lesson())
                && focus(studio) == focus(shown)
                && studio.title().equals(shown.title());
        StudioPath chosen = line == null ? StudioPath.ROOT : line.path().followed(shown, studio);
        shown = studio;
        if (!sameTree) {
            tree.show(studio, chosen);
        }
        show(tree.chosenLine());
    }

    private static Object focus(Studio studio) {
        return studio.camera() instanceof ThinLensCamera lens
                ? lens.focus()
                : studio.camera().getClass();
    }

    /** Chooses another line, unless a wrong value must be corrected or taken back first. */
    private void leaveFor(StudioTree.Line chosen) {
        StudioPath path = chosen.path();
        if (EntryField.in(formPanel).anyMatch(EntryField::isPending)) {
            tree.select(line.path());
        }
        choose(path);
    }

    /** Chooses a part, or the nearest part above it that exists, unless a wrong value must be corrected first. */
    public void choose(StudioPath part) {
        if (takesEntries()) {
            select(part);
        }
    }

    /** The way to the part that is chosen. */
    public StudioPath chosen() {
        return line.path();
    }

    private void select(StudioPath path) {
        tree.select(path);
        show(tree.chosenLine());
    }

    /** Takes what is typed into the form; if some of it is refused, goes there and returns false. */
    private boolean takesEntries() {
        boolean taken = EntryField.takeAll(formPanel);
        EntryField.in(formPanel)
                .filter(EntryField::isPending)
                .findFirst()
                .ifPresent(wrong -> wrong.field().requestFocusInWindow());
        return taken;
    }

    private void show(StudioTree.Line chosen) {
        boolean sameForm = line != null
                && form != null
                && line.path().equals(chosen.path())
                && line.type().equals(chosen.type());
        line = chosen;
        if (!sameForm) {
            replaceForm();
        }
        if (form != null) {
            form.show(Hiding.content(line.path().get(model.studio())));
        }
        enableButtons();
    }

    private void replaceForm() {
        formPanel.removeAll();
        note.setText("");
        formPanel.add(note.component(), "wmin 0");
        if (Branches.isList(line.type())) {
            form = null;
            note.setText(Texts.get("tree.list", line.label()));
        } else {
            StudioPath path = line.path();
            form = new FamilyEditor((Class<?>) line.type(), line.label(), note, value -> {
                StudioPath content = Hiding.content(path, path.get(model.studio()));
                model.set(PartChange.with(model.studio(), content, value));
            });
            formPanel.add(form.component(), "wmin 0");
            form.parts().ifPresent(parts -> formPanel.add(parts, "wmin 0, gaptop 5"));
        }
        formPanel.revalidate();
        formPanel.repaint();
    }

    /** The entry after which another one is added; null if that is added at the end of a list, or nowhere. */
    private StudioTree.Line entry() {
        return Branches.isList(line.type()) || isAll() ? null : tree.entry();
    }

    private int place() {
        return (Integer) line.path().last();
    }

    private void enableButtons() {
        boolean element = line.isEntry();
        add.setEnabled(entry() != null || Branches.isList(line.type()) || isAll());
        duplicate.setEnabled(element);
        remove.setEnabled(element);
        up.setEnabled(element && place() > 0);
        down.setEnabled(element && place() + 1 < list().size());
        hide.setEnabled(element && line.type() == SceneObject.class);
        boolean hidden = element && line.path().get(model.studio()) instanceof Hidden;
        hide.setText(Texts.get(hidden ? "tree.show" : "tree.hide"));
        match.setVisible(
                line.path().isWithin(ON_BOARD) && FrontWindow.of(model.studio()).isPresent());
        match.setEnabled(!FrontWindow.matches(model.studio()));
    }

    private boolean isAll() {
        return line.path().equals(StudioPath.ROOT);
    }

    /** The list of the chosen line; the list of objects if the whole studio is chosen, as it is at first. */
    private StudioPath listPath() {
        StudioTree.Line entry = entry();
        return entry != null ? entry.path().parent() : isAll() ? SCENE : line.path();
    }

    private List<?> list() {
        return (List<?>) listPath().get(model.studio());
    }

    private void offerTypes() {
        JPopupMenu menu = new JPopupMenu();
        StudioTree.Line entry = entry();
        Class<?> family = entry != null
                ? (Class<?>) entry.type()
                : isAll()
                        ? SceneObject.class
                        : Descriptions.elementType(line.type()).orElseThrow();
        offer(menu, family, this::addElement);
        if (isAll()) {
            menu.addSeparator();
            offer(menu, LightSource.class, type -> {
                select(LIGHTS);
                addElement(type);
            });
        }
        if (listPath().equals(ON_BOARD)) {
            menu.addSeparator();
            offer(menu, FrameWindow.class, this::addWindow);
        }
        menu.show(add, 0, -menu.getPreferredSize().height);
    }

    private static void offer(JPopupMenu menu, Class<?> family, Consumer<Class<?>> taker) {
        for (Class<?> type : Hiding.types(family)) {
            JMenuItem item = new JMenuItem(Wording.label(type), TinyDrawing.of(type));
            Naming.tip(item, Wording.meaning(type));
            item.addActionListener(event -> taker.accept(type));
            menu.add(item);
        }
    }

    /** Puts a window in front of the lens, with the velocity of the camera. */
    private void addWindow(Class<?> type) {
        if (takesEntries()) {
            FrameWindow window = ((FrameWindow) Descriptions.standard(type))
                    .withVelocity(model.studio().velocity());
            model.set(FrontWindow.with(model.studio(), window));
            select(ON_BOARD.then(0));
        }
    }

    /** Puts a new element of a type after the chosen one, or at the end of the chosen list. */
    void addElement(Class<?> type) {
        if (!takesEntries()) {
            return;
        }
        StudioPath path = listPath();
        StudioTree.Line entry = entry();
        int place = entry == null ? list().size() : (Integer) entry.path().last() + 1;
        List<?> before = list();
        Studio studio = model.studio();
        Object made = NewObject.of(type, before);
        Object added =
                path.equals(SCENE) && made instanceof SceneObject object ? InPicture.inSight(studio, object) : made;
        List<Object> longer = new ArrayList<>(before);
        longer.add(place, added);
        if (isFirstObject(path)) {
            NewObject.floorBeneath(added).ifPresent(longer::add);
        }
        if (note.attempt(() -> model.set(path.with(model.studio(), longer)))) {
            StudioPath element = path.then(place);
            // a mesh comes in a place
            select(type.isInstance(added) ? element : element.then("object"));
            if (added instanceof LightSource && !before.isEmpty()) {
                note.setText(Texts.get("tree.moreLight", before.size()));
            } else if (path.equals(SCENE) && !InPicture.isSeen(studio, (SceneObject) added)) {
                note.setText(Texts.get("tree.outOfPicture"));
            }
        }
    }

    private boolean isFirstObject(StudioPath list) {
        Studio studio = model.studio();
        return list.equals(SCENE)
                && studio.scene().isEmpty()
                && studio.cameraFrame().isEmpty();
    }

    private void changeList(Consumer<List<Object>> change, int step) {
        if (!takesEntries()) {
            return;
        }
        StudioPath path = listPath();
        int next = place() + step;
        List<Object> changed = new ArrayList<>(list());
        change.accept(changed);
        if (note.attempt(() -> model.set(path.with(model.studio(), changed)))) {
            select(changed.isEmpty() ? path : path.then(Math.max(0, Math.min(changed.size() - 1, next))));
        }
    }
}
