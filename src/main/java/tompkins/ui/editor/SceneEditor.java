package tompkins.ui.editor;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
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
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Column;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.TinyDrawing;
import tompkins.ui.widget.Wording;

/** All of the studio: a tree of its parts, and a form for the chosen one. */
public final class SceneEditor extends Part {

    private static final StudioPath SCENE = StudioPath.ROOT.then("scene");

    private final StudioModel model;
    private final StudioTree tree = new StudioTree(this::leaveFor);
    private final Column formPanel = new Column();
    private final TreeAndForm parts = new TreeAndForm(tree.component(), formPanel);
    private final Note note = new Note("");
    private final JButton add = Buttons.of("tree.add", this::offerTypes);
    private final JButton duplicate = button("duplicate", this::duplicate, 1);
    private final JButton hide = button("hide", this::hideOrShow, 0);
    private final JButton up = button("up", list -> Collections.swap(list, place(), place() - 1), -1);
    private final JButton down = button("down", list -> Collections.swap(list, place(), place() + 1), 1);
    private final JButton remove = Buttons.of("tree.remove", this::remove);
    private final JPanel buttons = new JPanel(buttons(false));
    private StudioTree.Line line;
    private FamilyEditor form;
    private Studio shown;

    /** An editor of the studio in a model, which follows its changes. */
    public SceneEditor(StudioModel model) {
        super(new JPanel(
                new MigLayout("novisualpadding, insets 10, fill, wrap 1, gap 0 8", "[grow,fill]", "[grow,fill][]")));
        this.model = model;
        panel.add(parts.component());
        for (JButton each : List.of(add, duplicate, hide, up, down, remove)) {
            buttons.add(each);
        }
        panel.add(buttons);
        Keys.bindFocused(tree.component(), KeyStroke.getKeyStroke("DELETE"), remove::doClick);
        model.follow(this::update);
    }

    /** Sets the sizes that do not follow the look by themselves; {@code tall} makes it narrow and high. */
    public void fitToLook(boolean tall) {
        parts.fitToLook(tall);
        buttons.setLayout(buttons(tall));
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

    private static MigLayout buttons(boolean tall) {
        return new MigLayout("novisualpadding, insets 0, gap 4" + (tall ? ", wrap 3" : ""), tall ? "[fill,sg]" : "");
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
                model.set(FrontWindow.following(model.studio(), content.with(model.studio(), value)));
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
        for (Class<?> type : Hiding.types(family)) {
            JMenuItem item = new JMenuItem(Wording.label(type), TinyDrawing.of(type));
            Naming.tip(item, Wording.meaning(type));
            item.addActionListener(event -> addElement(type));
            menu.add(item);
        }
        menu.show(add, 0, -menu.getPreferredSize().height);
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
        boolean hides = path.equals(SCENE) && !isFirstObject(path);
        Object made = NewObject.of(type, before, plane -> !hides || InPicture.isSeen(model.studio(), plane));
        Object added = path.equals(SCENE) && made instanceof SceneObject object
                ? InPicture.inSight(model.studio(), object)
                : made;
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
            } else if (path.equals(SCENE) && !InPicture.shows(model.studio(), (SceneObject) added)) {
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
