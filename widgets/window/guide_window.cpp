#include "widgets/window/guide_window.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QResizeEvent>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextFrame>
#include <QTextTable>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "simcore/io/project_file.h"
#include "widgets/window/icons.h"

namespace widgets {
namespace {

constexpr int kPageRole = Qt::UserRole;
constexpr int kHeadingRole = Qt::UserRole + 1;
constexpr int kDeepestListed = 2;  ///< level of headings in the contents

/// In the order in which one reads them; others follow by name.
const char* const kPages[] = {"studio.md",      "mobility.md", "statics.md",     "controllers.md",
                              "experiments.md", "review.md",   "project-file.md"};

/// Headings of a page with their levels, code blocks left out.
std::vector<std::pair<int, QString>> headingsOf(const QString& file) {
    std::vector<std::pair<int, QString>> headings;
    QFile page(file);
    if (!page.open(QIODevice::ReadOnly)) {
        return headings;
    }
    bool code = false;
    for (const QString& line : QString::fromUtf8(page.readAll()).split('\n')) {
        if (line.startsWith("```")) {
            code = !code;
        }
        const auto level = std::distance(
            line.begin(), std::find_if(line.begin(), line.end(), [](QChar c) { return c != '#'; }));
        if (!code && level > 0 && line.mid(level).startsWith(' ')) {
            headings.emplace_back(static_cast<int>(level), line.mid(level).trimmed());
        }
    }
    return headings;
}

}  // namespace

/// Pages as wide as the window: pictures shrink to it.
class GuideBrowser : public QTextBrowser {
  public:
    using QTextBrowser::QTextBrowser;

    void show(const QString& folder, const QString& page) {
        folder_ = folder;
        QFile file(folder + "/" + page);
        const QString text =
            file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
        // Made aside: every change of one on show would lay it out anew.
        QTextDocument* old = page_;
        page_ = new QTextDocument(this);
        page_->setDefaultFont(font());
        page_->setMarkdown(text);
        dress(*page_);
        fitPictures();
        setDocument(page_);
        delete old;
    }

  protected:
    void resizeEvent(QResizeEvent* event) override {
        QTextBrowser::resizeEvent(event);
        if (page_ != nullptr && event->size().width() != event->oldSize().width()) {
            fitPictures();
        }
    }

  private:
    /// Scaled here: the page itself scales roughly, and takes pixels of a fine screen for points.
    void fitPictures() {
        const int room = std::max(200, viewport()->width() - kAside);
        for (QTextBlock block = page_->begin(); block.isValid(); block = block.next()) {
            for (auto it = block.begin(); !it.atEnd(); ++it) {
                QTextImageFormat format = it.fragment().charFormat().toImageFormat();
                if (!format.isValid()) {
                    continue;
                }
                const QImage image(folder_ + "/" + format.name());
                const int width = std::min(room, image.width());
                if (image.isNull() || format.width() == width) {
                    continue;
                }
                const int pixels =
                    std::min(image.width(), static_cast<int>(width * devicePixelRatio()));
                page_->addResource(QTextDocument::ImageResource, QUrl(format.name()),
                                   image.scaledToWidth(pixels, Qt::SmoothTransformation));
                format.setWidth(width);
                format.setHeight(static_cast<double>(width) * image.height() / image.width());
                QTextCursor cursor(page_);
                cursor.setPosition(it.fragment().position());
                cursor.setPosition(it.fragment().position() + it.fragment().length(),
                                   QTextCursor::KeepAnchor);
                cursor.setCharFormat(format);
                break;  // the block's fragments are others now; pictures stand alone
            }
        }
    }

    /// Tables with lines and room, headings and lines with some air.
    void dress(QTextDocument& page) const {
        const QColor line = palette().color(QPalette::Mid);
        for (QTextFrame* frame : page.rootFrame()->childFrames()) {
            if (auto* table = qobject_cast<QTextTable*>(frame)) {
                QTextTableFormat format = table->format();
                format.setBorder(1.0);
                format.setBorderCollapse(true);
                format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
                format.setBorderBrush(line);
                format.setCellPadding(4.0);
                format.setCellSpacing(0.0);
                format.setTopMargin(6.0);
                format.setBottomMargin(10.0);
                table->setFormat(format);
            }
        }
        QTextFrameFormat root = page.rootFrame()->frameFormat();
        root.setMargin(kAside / 2.0);
        page.rootFrame()->setFrameFormat(root);
    }

    static constexpr int kAside = 40;  ///< both margins [px]
    QString folder_;
    QTextDocument* page_ = nullptr;
};

QString guideFolder() {
    const auto assets = simcore::io::examplesFolder().parent_path();
    for (const auto& place : {assets / "docs", assets.parent_path() / "docs"}) {
        const QString folder = QString::fromStdString(place.string());
        if (QFile::exists(folder + "/" + kPages[0])) {
            return QDir(folder).canonicalPath();
        }
    }
    return {};
}

QString headingName(const QString& heading) {
    QString name;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber() || c == '-' || c == '_') {
            name += c;
        } else if (c == ' ') {
            name += '-';
        }
    }
    return name;
}

GuideWindow::GuideWindow(QWidget* parent) : QDialog(parent) {
    setObjectName("guide");
    setWindowTitle(tr("User guide"));
    setWindowFlag(Qt::WindowMinMaxButtonsHint);
    text_ = new GuideBrowser;
    text_->setObjectName("guideText");
    text_->setAccessibleName(tr("Page"));
    text_->setOpenLinks(false);
    text_->setFrameShape(QFrame::NoFrame);
    contents_ = new QTreeWidget;
    contents_->setObjectName("guideContents");
    contents_->setAccessibleName(tr("Contents"));
    contents_->setHeaderHidden(true);
    contents_->setFrameShape(QFrame::NoFrame);
    search_ = new QLineEdit;
    search_->setObjectName("guideSearch");
    search_->setAccessibleName(tr("Search the guide"));
    search_->setPlaceholderText(tr("Search the guide"));
    search_->setClearButtonEnabled(true);
    const auto button = [this](const char* name, const QString& text, const QKeySequence& key,
                               void (GuideWindow::*slot)()) {
        auto* one = new QToolButton;
        one->setObjectName(name);
        one->setAccessibleName(text);
        one->setToolTip(text + " (" + key.toString(QKeySequence::NativeText) + ")");
        one->setAutoRaise(true);
        connect(one, &QToolButton::clicked, this, slot);
        connect(new QShortcut(key, this), &QShortcut::activated, this, slot);
        return one;
    };
    back_ = button("guideBack", tr("Back"), QKeySequence("Alt+Left"), &GuideWindow::goBack);
    forward_ =
        button("guideForward", tr("Forward"), QKeySequence("Alt+Right"), &GuideWindow::goForward);
    drawIcons();
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(6, 6, 6, 6);
    bar->addWidget(back_);
    bar->addWidget(forward_);
    bar->addWidget(search_, 1);
    auto* splitter = new QSplitter;
    splitter->addWidget(contents_);
    splitter->addWidget(text_);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    const int line = fontMetrics().height();
    splitter->setSizes({16 * line, 50 * line});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(bar);
    layout->addWidget(splitter, 1);
    resize(QSize(66, 48) * line);
    connect(text_, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
    connect(contents_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item != nullptr) {
            showPage(item->data(0, kPageRole).toString(), item->data(0, kHeadingRole).toString());
        }
    });
    // Enter is for searching on, not for a button of the dialog.
    connect(search_, &QLineEdit::returnPressed, this, [this] { findNext(search_->text()); });
    auto* find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, this, [this] {
        search_->setFocus();
        search_->selectAll();
    });
    for (const char* page : kPages) {
        pages_ << page;
    }
    for (const QString& page : QDir(guideFolder()).entryList({"*.md"}, QDir::Files, QDir::Name)) {
        if (!pages_.contains(page) && page.toLower() == page) {
            pages_ << page;
        }
    }
    fillContents();
    if (!showPage(pages_.front())) {
        text_->setPlainText(tr("The guide is not installed beside the program."));
    }
}

GuideWindow::~GuideWindow() = default;

void GuideWindow::fillContents() {
    const QString folder = guideFolder();
    for (const QString& page : pages_) {
        QTreeWidgetItem* top = nullptr;
        for (const auto& [level, heading] : headingsOf(folder + "/" + page)) {
            if (level > kDeepestListed || (level > 1 && top == nullptr)) {
                continue;
            }
            auto* item = level == 1 ? new QTreeWidgetItem(contents_) : new QTreeWidgetItem(top);
            item->setText(0, heading);
            item->setData(0, kPageRole, page);
            item->setData(0, kHeadingRole, level == 1 ? QString() : headingName(heading));
            top = level == 1 ? item : top;
        }
    }
    if (contents_->topLevelItemCount() > 0) {
        contents_->topLevelItem(0)->setExpanded(true);
    }
}

bool GuideWindow::load(const QString& page, const QString& heading) {
    const QString folder = guideFolder();
    if (folder.isEmpty() || !QFile::exists(folder + "/" + page)) {
        return false;
    }
    if (page != page_) {
        page_ = page;
        text_->show(folder, page);
    }
    scrollTo(heading);
    updateButtons();
    return true;
}

bool GuideWindow::showPage(const QString& page, const QString& heading) {
    if (!load(page, heading)) {
        return false;
    }
    const bool stays = place_ >= 0 && places_[static_cast<std::size_t>(place_)].page == page &&
                       places_[static_cast<std::size_t>(place_)].heading == heading;
    if (!stays) {
        places_.resize(static_cast<std::size_t>(place_ + 1));
        places_.push_back({page, heading});
        ++place_;
    }
    updateButtons();
    return true;
}

void GuideWindow::goBack() {
    if (place_ > 0) {
        --place_;
        const Place place = places_[static_cast<std::size_t>(place_)];
        load(place.page, place.heading);
    }
}

void GuideWindow::goForward() {
    if (place_ + 1 < static_cast<int>(places_.size())) {
        ++place_;
        const Place place = places_[static_cast<std::size_t>(place_)];
        load(place.page, place.heading);
    }
}

void GuideWindow::updateButtons() {
    back_->setEnabled(place_ > 0);
    forward_->setEnabled(place_ + 1 < static_cast<int>(places_.size()));
}

void GuideWindow::scrollTo(const QString& heading) {
    int top = 0;
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        if (!heading.isEmpty() && block.blockFormat().headingLevel() > 0 &&
            headingName(block.text()) == heading) {
            text_->setTextCursor(QTextCursor(block));
            top = static_cast<int>(
                text_->document()->documentLayout()->blockBoundingRect(block).top());
            break;
        }
    }
    if (top == 0) {
        text_->moveCursor(QTextCursor::Start);
    }
    text_->verticalScrollBar()->setValue(top);
}

QString GuideWindow::headingOnShow() const {
    QString heading;
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        const double top = text_->document()->documentLayout()->blockBoundingRect(block).top();
        if (top > text_->verticalScrollBar()->value() + 2.0) {
            break;
        }
        if (block.blockFormat().headingLevel() > 0) {
            heading = block.text();
        }
    }
    return heading;
}

void GuideWindow::follow(const QUrl& link) {
    if (link.isRelative() && (link.path().isEmpty() || link.path().endsWith(".md"))) {
        if (showPage(link.path().isEmpty() ? page_ : link.path(), link.fragment())) {
            return;
        }
    }
    QDesktopServices::openUrl(
        link.isRelative() ? QUrl::fromLocalFile(QDir(guideFolder()).filePath(link.path())) : link);
}

bool GuideWindow::findNext(const QString& text) {
    if (text.isEmpty()) {
        return false;
    }
    if (text_->find(text)) {
        return true;
    }
    const QString folder = guideFolder();
    const auto start = pages_.indexOf(page_);
    for (qsizetype i = 1; i <= pages_.size(); ++i) {
        const QString& page = pages_[(std::max<qsizetype>(start, 0) + i) % pages_.size()];
        QFile file(folder + "/" + page);
        // Without laying out every page: most do not have it.
        if (!file.open(QIODevice::ReadOnly) ||
            !QString::fromUtf8(file.readAll()).contains(text, Qt::CaseInsensitive)) {
            continue;
        }
        if (page != page_) {
            showPage(page);
        }
        text_->moveCursor(QTextCursor::Start);
        if (text_->find(text)) {
            return true;
        }
    }
    return false;
}

void GuideWindow::drawIcons() {
    back_->setIcon(lineIcon(Icon::Back, palette()));
    forward_->setIcon(lineIcon(Icon::Forward, palette()));
}

void GuideWindow::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && forward_ != nullptr) {
        drawIcons();
    }
    if ((event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) &&
        text_ != nullptr && !page_.isEmpty()) {
        const int value = text_->verticalScrollBar()->value();
        text_->show(guideFolder(), page_);
        text_->verticalScrollBar()->setValue(value);
    }
}

}  // namespace widgets
